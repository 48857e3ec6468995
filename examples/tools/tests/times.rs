//! The program `voxelize`: the times that it reports, and the option to draw no picture. The folder
//! `voxelize` tests the rest.

use std::fs;

use super::{directory, printed};

/// The milliseconds in the line that begins with `name`, if there is one.
fn milliseconds(report: &str, name: &str) -> Option<f64> {
    let line = report.lines().find(|line| line.starts_with(name))?;
    let [number, unit] = [1, 2].map(|i| line.split_whitespace().nth(i).unwrap());
    let factor = if unit.starts_with("ms") { 1.0 } else { 1000.0 };
    Some(number.parse::<f64>().unwrap() * factor)
}

#[test]
fn each_step_says_what_it_takes() {
    let directory = directory("times");
    let [report, _] = printed("voxelize", &["-r", "24", "-o", "a.png"], &directory);
    let [reading, voxelizing, drawing] =
        ["reading", "voxelizing", "picture"].map(|name| milliseconds(&report, name).unwrap());
    assert!(reading > 0.0 && voxelizing > 0.0, "{report}");
    assert!(drawing > voxelizing, "drawing takes far longer: {report}");
    assert!(report.contains("--no-picture"), "{report}");
}

#[test]
fn no_picture_but_the_same_voxels() {
    let directory = directory("no-picture");
    let with = ["-r", "24", "-o", "a.png", "--vox", "a.vox"];
    let [with_picture, _] = printed("voxelize", &with, &directory);
    let without = ["-r", "24", "--no-picture", "--vox", "b.vox"];
    let [report, _] = printed("voxelize", &without, &directory);
    assert!(milliseconds(&report, "drawing").is_none() && !report.contains("picture"), "{report}");
    assert!(milliseconds(&report, "voxelizing").is_some(), "{report}");
    let set = |report: &str| report.lines().find(|l| l.starts_with("set")).map(String::from);
    assert!(set(&report).is_some() && set(&report) == set(&with_picture));
    let model = |name| fs::read(directory.join(name)).unwrap();
    assert_eq!(model("a.vox"), model("b.vox"));
    // Neither the picture nor its directory.
    let files = fs::read_dir(&directory).unwrap().count();
    assert_eq!(files, 3, "a.png, a.vox and b.vox");
}
