//! Makes the functions of all types from those of `float`. A macro would not do: cbindgen reads the
//! source before macros are expanded.

use std::{env, fs};

fn main() {
    let out = env::var("OUT_DIR").unwrap();
    let [pairs, mesh] = ["pairs", "mesh"].map(of_float);
    let mesh32 = mesh
        .replace("u16>", "u32>")
        .replace("*mut u16", "*mut u32")
        .replace("[u16; 2]", "[u32; 2]")
        .replace("septum_tree_", "septum_tree32_");
    for (suffix, number) in [("i8f8", "I8F8"), ("i16f16", "I16F16"), ("f32", "f32"), ("f64", "f64")]
    {
        for (name, text) in [("pairs", &pairs), ("mesh", &mesh), ("mesh32", &mesh32)] {
            let text = text.replace("_f32", &format!("_{suffix}")).replace("f32", number);
            fs::write(format!("{out}/{name}_{suffix}.rs"), text).unwrap();
        }
    }
}

/// The functions of `float`, without the documentation of their file: `include!` refuses it.
fn of_float(name: &str) -> String {
    let path = format!("src/exports/{name}_f32.rs");
    println!("cargo::rerun-if-changed={path}");
    let text = fs::read_to_string(path).unwrap();
    text.lines().filter(|line| !line.starts_with("//!")).map(|line| format!("{line}\n")).collect()
}
