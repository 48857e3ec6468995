//! The programs, run as a user runs them.

mod documented;
mod gltf;
mod options;
mod printing;
mod quantise;
mod times;
mod voxelize;

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A directory for one test, empty at its start.
fn directory(test: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(test);
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).unwrap();
    path
}

/// A run of a program, in a directory.
fn command(program: &str, directory: &Path) -> Command {
    let mut command = Command::new(match program {
        "voxelize" => env!("CARGO_BIN_EXE_voxelize"),
        "quantise" => env!("CARGO_BIN_EXE_quantise"),
        _ => panic!("{program} is no program of this package"),
    });
    command.current_dir(directory);
    command
}

fn run(program: &str, arguments: &[&str], directory: &Path) -> Output {
    command(program, directory).args(arguments).output().unwrap()
}

/// The output of a successful run, and its error stream.
fn printed(program: &str, arguments: &[&str], directory: &Path) -> [String; 2] {
    let output = run(program, arguments, directory);
    let [out, errors] = [output.stdout, output.stderr].map(|s| String::from_utf8(s).unwrap());
    assert!(output.status.success(), "{program} {arguments:?}: {errors}");
    [out, errors]
}
