//! Dependencies point one way: no two files of a folder, and no two folders, need each other.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// A module, by the names that lead to it.
type Module = Vec<String>;

/// The source of each module but those of tests.
fn modules(folder: &Path, at: &[String], found: &mut BTreeMap<Module, String>) {
    for entry in fs::read_dir(folder).unwrap().map(Result::unwrap) {
        let path = entry.path();
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        let within = |name: String| [at, &[name]].concat();
        match name.as_str() {
            "tests" | "counts" | "lib" => {}
            _ if path.is_dir() => modules(&path, &within(name), found),
            _ if path.extension().is_none_or(|kind| kind != "rs") => {}
            "mod" => _ = found.insert(at.to_vec(), without_tests(&path)),
            _ => _ = found.insert(within(name), without_tests(&path)),
        }
    }
}

/// The source up to its tests.
fn without_tests(path: &Path) -> String {
    let source = fs::read_to_string(path).unwrap();
    let lines: Vec<_> = source.lines().filter(|line| !line.trim().starts_with("//")).collect();
    let is_tests = |pair: &[&str]| {
        pair[0].starts_with("#[cfg(")
            && pair[0].contains("test")
            && pair[1].ends_with("mod tests {")
    };
    let end = lines.windows(2).position(is_tests).unwrap_or(lines.len());
    lines[..end].join(" ")
}

/// The paths of an import, without braces.
fn paths(import: &str) -> Vec<String> {
    let Some((prefix, list)) = import.split_once('{') else { return vec![import.into()] };
    let list = &list[..list.rfind('}').unwrap()];
    let (mut all, mut depth) = (vec![String::new()], 0);
    for c in list.chars() {
        depth += i32::from(c == '{') - i32::from(c == '}');
        match c {
            ',' if depth == 0 => all.push(String::new()),
            _ => all.last_mut().unwrap().push(c),
        }
    }
    all.iter().flat_map(|path| paths(&format!("{prefix}{}", path.trim()))).collect()
}

/// The module that a path leads to.
fn named<'a>(
    path: &str,
    from: &[String],
    known: &'a BTreeMap<Module, String>,
) -> Option<&'a Module> {
    let mut at = from.to_vec();
    for (n, name) in path.split("::").map(str::trim).enumerate() {
        match name {
            "crate" => at.clear(),
            "self" => {}
            "super" => _ = at.pop(),
            _ if n == 0 => return None,
            name => {
                at.push(name.into());
                if !known.contains_key(&at) {
                    at.pop();
                    break;
                }
            }
        }
    }
    known.get_key_value(&at).map(|(module, _)| module)
}

#[test]
fn no_circles() {
    let mut known = BTreeMap::new();
    modules(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), &[], &mut known);
    // Who needs whom: children of the same module, which stand for all that is below them.
    let mut needs = BTreeMap::<Module, BTreeSet<Module>>::new();
    for (from, source) in &known {
        let imports = source.split("use ").skip(1).filter_map(|rest| Some(rest.split_once(';')?.0));
        for to in imports.flat_map(paths).filter_map(|path| named(&path, from, &known)) {
            let shared = from.iter().zip(to).take_while(|(a, b)| a == b).count();
            if shared < from.len().min(to.len()) {
                let needed = to[..=shared].to_vec();
                needs.entry(from[..=shared].to_vec()).or_default().insert(needed);
            }
        }
    }
    assert!(known.len() > 200 && needs.len() > 150, "{} {}", known.len(), needs.len());
    // What needs nothing that is left is in no circle.
    while let Some(free) = needs
        .iter()
        .find(|(_, all)| all.iter().all(|to| !needs.contains_key(to)))
        .map(|(module, _)| module.clone())
    {
        needs.remove(&free);
    }
    let named: Vec<String> = needs.keys().map(|module| module.join("::")).collect();
    assert!(named.is_empty(), "circles, or what leads to them: {named:?}");
}
