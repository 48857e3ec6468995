//! The header matches the library.

use std::fs;

/// `UPDATE=1 cargo test` writes the header.
#[test]
fn the_header_is_that_of_the_source() {
    let root = env!("CARGO_MANIFEST_DIR");
    let mut config = cbindgen::Config::from_file(format!("{root}/cbindgen.toml")).unwrap();
    for (rust, c) in config.export.rename.clone() {
        for number in ["I8F8", "I16F16", "f32", "f64"] {
            let suffix = number.to_lowercase();
            // Meshes and trees have indices too.
            for (index, wide) in [("", ""), ("__u16", ""), ("__u32", "32")] {
                let rust = format!("{rust}_{number}{index}");
                config.export.rename.insert(rust, format!("{c}{wide}_{suffix}"));
            }
        }
    }

    let numbers = ["i8f8", "i16f16", "f32", "f64"];
    let pairs = numbers.map(|number| format!("pairs_{number}"));
    let meshes = numbers.map(|number| format!("mesh_{number}"));
    let wide = ["f32", "f64"].map(|number| format!("mesh32_{number}"));
    // build.rs writes the functions of all types there, `float` too.
    let exports = [&pairs[..], &meshes, &wide].concat();
    let exports = exports.iter().map(|name| format!("{}/{name}.rs", env!("OUT_DIR")));
    let sources = ["number", "shapes", "text", "mesh"].map(|name| format!("{root}/src/{name}.rs"));
    let builder = cbindgen::Builder::new().with_config(config);
    let builder = sources.into_iter().chain(exports).fold(builder, cbindgen::Builder::with_src);
    let mut made = Vec::new();
    builder.generate().unwrap().write(&mut made);
    let made = String::from_utf8(made).unwrap();

    let path = format!("{root}/include/septum.h");
    if std::env::var_os("UPDATE").is_some() {
        fs::write(&path, &made).unwrap();
    }
    let kept = fs::read_to_string(&path).unwrap_or_default();
    assert!(kept == made, "{path} is not what is made:\n{made}");
}
