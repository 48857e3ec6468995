//! The examples, run as a user runs them.

mod keep_out;
#[rustfmt::skip]
#[allow(dead_code, reason = "its tree is for others")]
#[path = "../../../examples/assets/teapot.rs"]
pub(crate) mod teapot;
mod walking;

use septum_kit::Each;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::Mutex;

/// A directory for one test, empty at its start.
fn directory(test: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("examples").join(test);
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).unwrap();
    path
}

/// Builds an example, once: `cargo test` builds examples, `cargo test --test promises` does not.
fn built(example: &str, target: &Path) {
    static BUILDING: Mutex<()> = Mutex::new(());
    let _one_at_a_time = BUILDING.lock();
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["build", "--quiet", "--manifest-path"]);
    cargo.arg(Path::new(env!("CARGO_MANIFEST_DIR")).join("Cargo.toml"));
    cargo.args(["--example", example, "--target-dir"]).arg(target.parent().unwrap());
    // The folder is named after the profile, except for the development profile.
    let profile = target.file_name().and_then(|name| name.to_str()).unwrap();
    cargo.args(["--profile", if profile == "debug" { "dev" } else { profile }]);
    assert!(cargo.status().unwrap().success(), "{example}");
}

/// Where this build is.
fn target() -> PathBuf {
    let test = std::env::current_exe().unwrap();
    test.parent().and_then(Path::parent).unwrap().into()
}

/// Runs an example.
fn run(example: &str, arguments: &[&str], directory: &Path) -> Output {
    let target = target();
    let program =
        target.join("examples").join(example).with_extension(std::env::consts::EXE_EXTENSION);
    if !program.exists() {
        built(example, &target);
    }
    Command::new(program).args(arguments).current_dir(directory).output().unwrap()
}

/// The output of a successful run, and its error stream.
fn printed(example: &str, arguments: &[&str], directory: &Path) -> [String; 2] {
    let output = run(example, arguments, directory);
    let [out, errors] = [output.stdout, output.stderr].each(|s| String::from_utf8(s).unwrap());
    assert!(output.status.success(), "{example} {arguments:?}: {errors}");
    [out, errors]
}
