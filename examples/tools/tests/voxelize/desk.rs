//! Runs the program in a directory with files, and checks the results.

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};

use dot_vox::DotVoxData;

/// A directory for one test, empty at its start.
pub(super) struct Desk(pub(super) PathBuf);

impl Desk {
    pub(super) fn new(test: &str) -> Self {
        Self(crate::directory(&format!("voxelize-{test}")))
    }

    pub(super) fn write(&self, name: &str, content: impl AsRef<[u8]>) {
        fs::write(self.0.join(name), content).unwrap();
    }

    pub(super) fn exists(&self, name: &str) -> bool {
        self.0.join(name).exists()
    }

    pub(super) fn run(&self, arguments: &str) -> Output {
        self.command(arguments).output().unwrap()
    }

    pub(super) fn command(&self, arguments: &str) -> Command {
        let mut command = crate::command("voxelize", &self.0);
        command.args(arguments.split_whitespace());
        command
    }

    pub(super) fn succeed(&self, arguments: &str) -> String {
        let output = self.run(arguments);
        let errors = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{arguments}: {errors}");
        String::from_utf8(output.stdout).unwrap()
    }

    /// The model that a successful run wrote.
    pub(super) fn model(&self, arguments: &str) -> DotVoxData {
        self.succeed(&format!("{arguments} --no-picture --vox a.vox"));
        dot_vox::load_bytes(&fs::read(self.0.join("a.vox")).unwrap()).unwrap()
    }

    /// Voxels of the model, sorted.
    pub(super) fn voxels(&self, arguments: &str) -> Vec<[u8; 3]> {
        let voxels = &self.model(arguments).models[0].voxels;
        let mut voxels: Vec<_> = voxels.iter().map(|v| [v.x, v.y, v.z]).collect();
        voxels.sort_unstable();
        voxels
    }

    /// Every failure is one line on stderr, with the exit code of an expected error.
    pub(super) fn fail(&self, arguments: &str, says: &[&str]) {
        let output = self.run(arguments);
        let errors = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(1), "{arguments}: {errors}");
        assert!(output.stdout.is_empty(), "{arguments}");
        assert!(errors.starts_with("error: "), "{arguments}: {errors}");
        assert_eq!(errors.trim_end().lines().count(), 1, "{arguments}: {errors}");
        for part in says {
            assert!(errors.contains(part), "{arguments}: `{part}` is not in {errors}");
        }
    }
}

/// The surface of a box as an OBJ file, of quads; vertices after `before` others.
pub(super) fn cuboid([x0, y0, z0]: [i32; 3], [x1, y1, z1]: [i32; 3], before: i32) -> String {
    let mut obj = String::new();
    for i in 0..8 {
        let pick = |bit: i32, a, b| if i >> bit & 1 == 0 { a } else { b };
        obj += &format!("v {} {} {}\n", pick(0, x0, x1), pick(1, y0, y1), pick(2, z0, z1));
    }
    for quad in [[1, 2, 4, 3], [5, 6, 8, 7], [1, 2, 6, 5], [3, 4, 8, 7], [1, 3, 7, 5], [2, 4, 8, 6]]
    {
        let [a, b, c, d] = quad.map(|i| i + before);
        obj += &format!("f {a} {b} {c} {d}\n");
    }
    obj
}

pub(super) const TRIANGLE: &str = "v 0 0 0\nv 4 0 0\nv 0 3 1\nf 1 2 3\n";

/// The number in the line that begins with `name`.
pub(super) fn figure(report: &str, name: &str) -> u64 {
    let line = report.lines().find(|l| l.starts_with(name)).unwrap();
    let number = line.split_whitespace().nth(1).unwrap();
    number.replace(',', "").parse().unwrap()
}
