//! Compiles the peers in C++, with the feature `native`.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    #[cfg(feature = "native")]
    native::compile();
}

#[cfg(feature = "native")]
mod native {
    use std::path::{Path, PathBuf};
    use std::process::Command;

    pub fn compile() {
        let [jolt, tinybvh] = ["joltc-sys", "tinybvh-rs"].map(source_of);
        let mut build = cc::Build::new();
        build.cpp(true).std("gnu++20").opt_level(3).define("NDEBUG", None).warnings(false);
        // They find out when compiled what vectors there are.
        build.flag("-march=native");
        build.include(jolt.join("JoltC/JoltPhysics")).include(tinybvh.join("ffi/tinybvh"));
        build.include("/usr/include/bullet");
        for peer in ["bullet", "bullet_ball", "embree", "jolt", "jolt_ball", "tinybvh"] {
            let file = format!("native/{peer}.cpp");
            println!("cargo::rerun-if-changed={file}");
            build.file(file);
        }
        // A sphere of Jolt knows all shapes, and these all of Jolt.
        all_below(&jolt.join("JoltC/JoltPhysics/Jolt"), &mut |file| {
            build.file(file);
        });
        build.compile("peers");
        for library in ["BulletCollision", "LinearMath", "embree3"] {
            println!("cargo::rustc-link-lib={library}");
        }
    }

    /// Visits each C++ file in a folder and below it.
    fn all_below(folder: &Path, visit: &mut impl FnMut(&Path)) {
        for entry in std::fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("a file or folder").path();
            if path.is_dir() {
                all_below(&path, visit);
            } else if path.extension().is_some_and(|end| end == "cpp") {
                visit(&path);
            }
        }
    }

    /// The folder where cargo keeps a package's source.
    fn source_of(package: &str) -> PathBuf {
        let cargo = std::env::var_os("CARGO").expect("cargo names itself");
        let told = Command::new(cargo).args(["metadata", "--format-version", "1"]).output();
        let told = String::from_utf8(told.expect("cargo starts").stdout).expect("JSON is UTF-8");
        let manifests = told.split("\"manifest_path\":\"").skip(1);
        let folders = manifests.filter_map(|rest| Path::new(rest.split('"').next()?).parent());
        let is_it = |folder: &&Path| {
            let name = folder.file_name().and_then(|name| name.to_str());
            name.is_some_and(|name| name.starts_with(package))
        };
        folders.into_iter().find(is_it).expect("it is in Cargo.lock").to_path_buf()
    }
}
