//! A user's mistake is reported in one line, with the valid values.

use std::fs;
use std::process::Stdio;

use super::{command, directory, printed, run};

/// Each of these is refused with one line that contains these words.
fn refused(example: &str, cases: &[(&str, &str)]) {
    let directory = directory(&format!("refused-{example}"));
    fs::write(directory.join("far.obj"), "v 1e30 1 1\nv 1e30 1 2\nv 1e30 4 2\nf 1 2 3\n").unwrap();
    for (arguments, says) in cases {
        let words: Vec<&str> = arguments.split(' ').collect();
        let output = run(example, &words, &directory);
        let errors = String::from_utf8(output.stderr).unwrap();
        assert!(matches!(output.status.code(), Some(1 | 2)), "{example} {arguments}: {errors}");
        assert!(output.stdout.is_empty(), "{example} {arguments}");
        assert!(errors.starts_with("error: "), "{example} {arguments}: {errors}");
        assert_eq!(errors.trim_end().lines().count(), 1, "{example} {arguments}: {errors}");
        assert!(errors.chars().count() < 250, "{example} {arguments}: {errors}");
        assert!(errors.contains(says), "{example} {arguments}: no `{says}` in {errors}");
    }
}

#[test]
fn voxelize() {
    refused(
        "voxelize",
        &[
            ("-s f16", "f32, f64, i8f8, i16f16, i32f32"),
            ("--scalar fixed", "f32, f64, i8f8, i16f16, i32f32"),
            ("-m best", "rows, per-voxel, exact-pairs, conservative, published, rounded"),
            ("-u x", "y, z"),
            ("-r many", "not a whole number"),
            ("-r -5", "not a whole number"),
            ("-r 1e3", "not a whole number"),
            ("-r 99999999999", "not a whole number of 32 bits"),
            ("-r 0", "at least one voxel"),
            ("-t 1025", "not a whole number of at most 1024"),
            ("--no-picture -o a.png", "cannot be used with"),
            ("--no-pictures", "--no-pictures"),
            ("--vox", "--vox"),
            ("none.obj", "none.obj"),
            ("a.obj b.obj", "a.obj"),
        ],
    );
}

#[test]
fn quantise() {
    refused(
        "quantise",
        &[
            ("--scalar f32", "i4f4, i8f8, i16f16, i32f32"),
            ("--up x", "y, z"),
            ("--scale 0", "above zero"),
            ("--scale nan", "above zero"),
            ("--scale -2", "above zero"),
            ("--scale 1e300", "beyond the range of I16F16"),
            ("far.obj", "1e30 is beyond the range of I16F16: see --scale"),
        ],
    );
}

#[test]
fn names_in_any_case() {
    let directory = directory("names");
    for (name, other) in [("i8f8", "I8F8"), ("i16f16", "I16f16"), ("i32f32", "I32F32")] {
        let table = |name| printed("quantise", &["--scalar", name, "--scale", "0.5"], &directory);
        assert_eq!(table(name), table(other));
    }
    for (name, other) in [
        ("f32", "F32"),
        ("f64", "F64"),
        ("i8f8", "I8F8"),
        ("i16f16", "I16F16"),
        ("i32f32", "i32F32"),
    ] {
        let voxels = |name| {
            let [report, _] =
                printed("voxelize", &["-r", "16", "--no-picture", "-s", name], &directory);
            let is_the_same =
                |line: &&str| !line.starts_with("reading") && !line.starts_with("voxelizing");
            report.lines().filter(is_the_same).map(String::from).collect::<Vec<_>>()
        };
        assert!(voxels(name).iter().any(|line| line.starts_with(&format!("scalar     {name}"))));
        assert_eq!(voxels(name), voxels(other));
    }
    let arguments = ["-r", "8", "--no-picture", "-m", "EXACT", "--up", "Z"];
    assert!(printed("voxelize", &arguments, &directory)[0].contains("exact"));
}

/// The text that `--help` prints is no error.
#[test]
fn help() {
    for example in ["voxelize", "quantise"] {
        let [help, errors] = printed(example, &["--help"], &directory("help"));
        assert!(help.contains("Usage:") && errors.is_empty(), "{example}: {help}{errors}");
    }
}

/// As of `| head`, once it has its lines.
#[test]
fn a_closed_pipe_is_no_error() {
    for (example, arguments) in [("voxelize", &["-r", "8", "--no-picture"][..]), ("quantise", &[])]
    {
        let directory = directory("pipe");
        let mut program = command(example, &directory)
            .args(arguments)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        drop(program.stdout.take());
        let output = program.wait_with_output().unwrap();
        let errors = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.success() && !errors.contains("panic"), "{example}: {errors}");
    }
}
