//! The table of what programs may take.

use std::error::Error;
use std::fs;
use std::path::Path;

use crate::firmware::Kind;

/// What one program may take on one target.
pub struct Budget {
    pub program: String,
    /// Bytes of code and constants, beyond an empty program, without the run-time's.
    pub own: u64,
    /// Bytes of the language's own functions, where they are compiled with the program.
    pub run_time: u64,
    /// Bytes, at most.
    pub stack: u64,
    /// The same where the shapes are near to each other, if that is another budget.
    pub stack_nearby: Option<u64>,
    pub may_link: Vec<Kind>,
}

/// The lines about a target.
pub fn read(path: &Path, target: &str) -> Result<Vec<Budget>, Box<dyn Error>> {
    let table = fs::read_to_string(path)?;
    let mut budgets = Vec::new();
    for line in table.lines().skip(1) {
        let columns: Vec<&str> = line.split(',').collect();
        let [program, on, own, run_time, stack, nearby, may_link] = columns[..] else {
            return Err(format!("{}: seven columns, please: {line}", path.display()).into());
        };
        let kind = |name| Kind::ALL.into_iter().find(|kind| kind.to_string() == name);
        if on == target {
            budgets.push(Budget {
                program: program.into(),
                own: own.parse()?,
                run_time: run_time.parse()?,
                stack: stack.parse()?,
                stack_nearby: Some(nearby).filter(|s| !s.is_empty()).map(str::parse).transpose()?,
                may_link: may_link
                    .split(';')
                    .filter(|name| !name.is_empty())
                    .map(|name| kind(name).ok_or(format!("what is a {name}?")))
                    .collect::<Result<_, _>>()?,
            });
        }
    }
    if budgets.is_empty() { Err(format!("no budget for {target}").into()) } else { Ok(budgets) }
}
