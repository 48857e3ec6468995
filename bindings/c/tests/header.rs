//! The header matches the library.

/// `UPDATE=1 cargo test` writes it.
#[test]
fn the_header_is_that_of_the_source() {
    let root = env!("CARGO_MANIFEST_DIR");
    let config = cbindgen::Config::from_file(format!("{root}/cbindgen.toml")).unwrap();
    let builder = cbindgen::Builder::new().with_config(config);
    let files = ["number", "shapes", "queries", "mesh"].map(|name| format!("{root}/src/{name}.rs"));
    let builder = files.iter().fold(builder, |builder, file| builder.with_src(file));
    let mut made = Vec::new();
    builder.generate().unwrap().write(&mut made);
    let made = String::from_utf8(made).unwrap();
    let path = format!("{root}/include/septum.h");
    if std::env::var_os("UPDATE").is_some() {
        std::fs::write(&path, &made).unwrap();
    }
    let kept = std::fs::read_to_string(&path).unwrap();
    assert!(kept == made, "include/septum.h is not what cbindgen makes:\n{made}");
}
