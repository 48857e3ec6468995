//! The programs accept the commands that the documentation shows.

use std::fs;
use std::path::Path;

use super::{directory, printed};

/// The arguments of each command in a text that runs this program: of a line, or between backticks.
fn arguments<'a>(text: &'a str, program: &str) -> impl Iterator<Item = Vec<&'a str>> {
    let command = format!("cargo {program}");
    let starts: Vec<usize> = text.match_indices(&command).map(|(start, _)| start).collect();
    starts.into_iter().map(move |start| {
        let end = if text[..start].ends_with('`') { '`' } else { '\n' };
        let own = text[start + command.len()..].split(end).next().unwrap_or_default();
        // Without what is for the shell.
        own.split(['#', '<', '>', '|']).next().unwrap_or_default().split_whitespace().collect()
    })
}

#[test]
fn commands_of_the_pages() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let pages = fs::read_dir(root.join("docs")).unwrap().map(|entry| entry.unwrap().path());
    let others = ["README.md", "examples/firmware-template/README.md"].map(|page| root.join(page));
    let own =
        ["voxelize", "quantise"].map(|name| root.join("examples/tools").join(name).join("main.rs"));
    let mut shown = 0;
    for page in pages.chain(others).chain(own).filter(|page| page.is_file()) {
        let Ok(text) = fs::read_to_string(&page) else { continue };
        for program in ["voxelize", "quantise"] {
            for mut arguments in arguments(&text, program) {
                // Options are read in their order, and this one is answered by what they mean.
                arguments.push("--help");
                let [help, _] = printed(program, &arguments, &directory("documented"));
                assert!(help.contains("Usage:"), "{}: {arguments:?}", page.display());
                shown += 1;
            }
        }
    }
    assert!(shown > 10, "{shown} commands");
}
