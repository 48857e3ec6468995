//! The header matches the library, and the files of all types that of `float`.

use std::fs;

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// `UPDATE=1 cargo test` writes it.
fn is_kept(path: &str, made: &str) {
    let path = format!("{ROOT}/{path}");
    if std::env::var_os("UPDATE").is_some() {
        fs::write(&path, made).unwrap();
    }
    let kept = fs::read_to_string(&path).unwrap_or_default();
    assert!(kept == made, "{path} is not what is made:\n{made}");
}

/// The files of the other types, by those of `float`.
fn files() -> Vec<(String, String)> {
    let read =
        |name: &str| fs::read_to_string(format!("{ROOT}/src/exports/{name}_f32.rs")).unwrap();
    let (pairs, mesh) = (read("pairs"), read("mesh"));
    let wide = mesh
        .replace("u16>", "u32>")
        .replace("*mut u16", "*mut u32")
        .replace("[u16; 2]", "[u32; 2]");
    let wide = wide.replace("septum_tree_", "septum_tree32_").replace("of 16 bits", "of 32 bits");
    let mut files = vec![("mesh32_f32".to_string(), wide.clone())];
    for (suffix, number, called) in
        [("i8f8", "I8F8", "I8F8"), ("i16f16", "I16F16", "I16F16"), ("f64", "f64", "double")]
    {
        let named = |text: &str| {
            let text = text
                .replace("_f32", &format!("_{suffix}"))
                .replace("`float`", &format!("`{called}`"));
            text.replace("f32", number)
        };
        files.push((format!("pairs_{suffix}"), named(&pairs)));
        files.push((format!("mesh_{suffix}"), named(&mesh)));
        if suffix == "f64" {
            files.push((format!("mesh32_{suffix}"), named(&wide)));
        }
    }
    files
}

#[test]
fn all_types_have_the_functions_of_float() {
    for (name, text) in files() {
        // Where its names are longer rustfmt breaks a line.
        let text = format(&text);
        is_kept(&format!("src/exports/{name}.rs"), &text);
    }
}

fn format(text: &str) -> String {
    use std::io::Write;
    use std::process::{Command, Stdio};
    let config = format!("{ROOT}/../../rustfmt.toml");
    let mut rustfmt = Command::new("rustfmt")
        .args(["--edition", "2024", "--config-path", &config])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    rustfmt.stdin.take().unwrap().write_all(text.as_bytes()).unwrap();
    String::from_utf8(rustfmt.wait_with_output().unwrap().stdout).unwrap()
}

#[test]
fn the_header_is_that_of_the_source() {
    let config = cbindgen::Config::from_file(format!("{ROOT}/cbindgen.toml")).unwrap();
    let builder = cbindgen::Builder::new().with_config(config);
    let exports = ["i8f8", "i16f16", "f32", "f64"];
    let pairs = exports.map(|name| format!("exports/pairs_{name}"));
    let meshes = exports.map(|name| format!("exports/mesh_{name}"));
    let wide = ["f32", "f64"].map(|name| format!("exports/mesh32_{name}"));
    let first = ["number", "shapes", "text", "mesh"].map(String::from);
    let files = first.iter().chain(&pairs).chain(&meshes).chain(&wide);
    let builder =
        files.fold(builder, |builder, name| builder.with_src(format!("{ROOT}/src/{name}.rs")));
    let mut made = Vec::new();
    builder.generate().unwrap().write(&mut made);
    is_kept("include/septum.h", &String::from_utf8(made).unwrap());
}
