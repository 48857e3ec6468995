//! A linked program: its size, its stack, and what is in it that should not be.

use std::collections::{BTreeMap, HashMap, HashSet};
use std::error::Error;
use std::fmt;
use std::fs;
use std::path::Path;

use object::read::elf::ElfFile32;
use object::{Object, ObjectSection, ObjectSymbol, RelocationTarget, SymbolKind};

/// What a program may have to do without.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    Panic,
    SoftFloat,
    Division,
}

impl Kind {
    pub const ALL: [Self; 3] = [Self::Panic, Self::SoftFloat, Self::Division];

    /// Whether a symbol, demangled, is one of this kind. The names of the helpers are
    /// those of the run-time ABI for Arm, or of compiler-builtins.
    fn has(self, name: &str) -> bool {
        let is_of = |prefixes: &[&str]| prefixes.iter().any(|prefix| name.starts_with(prefix));
        match self {
            Self::Panic => {
                ["panicking", "rust_begin_unwind", "panic_fmt"].iter().any(|p| name.contains(p))
            }
            Self::SoftFloat => {
                let float = |c| c == 'f' || c == 'd';
                name.strip_prefix("__aeabi_").is_some_and(|rest| {
                    rest.starts_with(float) || rest.contains('2') && rest.ends_with(float)
                }) || ["sf3", "df3", "sf2", "df2"].iter().any(|end| name.ends_with(end))
            }
            Self::Division => {
                is_of(&["__aeabi_ldiv", "__aeabi_uldiv", "__divdi3", "__udivdi3", "__moddi3"])
                    || is_of(&[
                        "__umoddi3",
                        "__udivmoddi4",
                        "__divti3",
                        "__udivti3",
                        "__udivmodti4",
                    ])
            }
        }
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Panic => "panic",
            Self::SoftFloat => "soft float",
            Self::Division => "64-bit division",
        })
    }
}

/// A program.
pub struct Firmware {
    /// Bytes of code and constants.
    text: u64,
    functions: BTreeMap<u64, Function>,
}

struct Function {
    name: String,
    end: u64,
    /// The bytes of stack that it takes itself.
    frame: u64,
    calls: HashSet<u64>,
}

impl Function {
    /// Whether it is the language's own: soft floats, wide division, copies of memory. It
    /// comes with `core`, from whoever compiled that.
    fn is_run_time(&self) -> bool {
        self.name != "_start" && ["septum::", "fixed::"].iter().all(|own| !self.name.contains(own))
    }
}

/// The address of a function: in Thumb code the last bit is none of it.
fn address(symbol: u64) -> u64 {
    symbol & !1
}

impl Firmware {
    /// Reads a program that was built with `-Zemit-stack-sizes`, and linked with
    /// `--emit-relocs`, which keeps a note of every call.
    pub fn read(path: &Path) -> Result<Self, Box<dyn Error>> {
        let data = fs::read(path)?;
        let elf = ElfFile32::<object::Endianness>::parse(&*data)?;
        let sized = [".text", ".rodata"].map(|name| elf.section_by_name(name));
        let text = sized.iter().flatten().map(ObjectSection::size).sum();
        let frames = match elf.section_by_name(".stack_sizes") {
            Some(section) => frames(section.data()?),
            None => HashMap::new(),
        };

        let section = elf.section_by_name(".text").ok_or("there is no .text")?;
        let (code, origin) = (section.data()?, section.address());
        let code = |start: u64| start.checked_sub(origin).and_then(|at| code.get(at as usize..));

        let mut functions = BTreeMap::new();
        for symbol in elf.symbols().filter(|s| s.kind() == SymbolKind::Text && s.size() > 0) {
            let start = address(symbol.address());
            functions.insert(
                start,
                Function {
                    name: format!("{:#}", rustc_demangle::demangle(symbol.name()?)),
                    end: start + symbol.size(),
                    frame: frames.get(&start).copied().unwrap_or_else(|| opening(code(start))),
                    calls: HashSet::new(),
                },
            );
        }
        for (at, relocation) in elf.sections().flat_map(|s| s.relocations().collect::<Vec<_>>()) {
            let RelocationTarget::Symbol(index) = relocation.target() else { continue };
            let to = address(elf.symbol_by_index(index)?.address());
            // Where a function's address is taken, that counts as a call too.
            if functions.contains_key(&to)
                && let Some((&start, from)) = functions.range_mut(..=at).next_back()
                && at < from.end
                && start != to
            {
                from.calls.insert(to);
            }
        }
        Ok(Self { text, functions })
    }

    /// Bytes of the language's own functions.
    pub fn run_time_text(&self) -> u64 {
        let functions = self.functions.iter().filter(|(_, function)| function.is_run_time());
        functions.map(|(start, function)| function.end - start).sum()
    }

    /// Bytes of all else.
    pub fn own_text(&self) -> u64 {
        self.text - self.run_time_text()
    }

    /// The names of what is linked of a kind.
    pub fn links(&self, kind: Kind) -> Vec<&str> {
        let names = self.functions.values().map(|f| f.name.as_str());
        names.filter(|name| kind.has(name)).collect()
    }

    /// The deepest stack below the entry, by the frames along each way down, but not
    /// through functions with that in their names.
    pub fn stack(&self, without: Option<&str>) -> Result<u64, String> {
        let entry = self.functions.iter().find(|(_, f)| f.name == "_start");
        let (&entry, _) = entry.ok_or("there is no _start")?;
        let is_skipped = |f: &Function| without.is_some_and(|part| f.name.contains(part));
        if without.is_some() && !self.functions.values().any(is_skipped) {
            return Err(format!("there is no {}", without.unwrap_or_default()));
        }
        self.below(entry, &is_skipped, &mut Vec::new())
    }

    fn below(
        &self,
        at: u64,
        is_skipped: &dyn Fn(&Function) -> bool,
        above: &mut Vec<u64>,
    ) -> Result<u64, String> {
        let function = &self.functions[&at];
        if is_skipped(function) {
            return Ok(0);
        }
        if above.contains(&at) {
            return Err(format!("{} calls itself", function.name));
        }
        above.push(at);
        let mut deepest = 0;
        for &callee in &function.calls {
            deepest = self.below(callee, is_skipped, above)?.max(deepest);
        }
        above.pop();
        Ok(function.frame + deepest)
    }
}

/// The stack that a function takes by its first instructions, for those that were
/// written in assembly, or compiled beforehand: of Thumb `push` and `sub sp`.
fn opening(code: Option<&[u8]>) -> u64 {
    let (code, _) = code.unwrap_or_default().as_chunks::<2>();
    let mut frame = 0;
    let mut words = code.iter().map(|&word| u16::from_le_bytes(word));
    while let Some(word) = words.next() {
        frame += match word {
            0xb400..=0xb5ff => 4 * u64::from((word & 0x1ff).count_ones()),
            0xb080..=0xb0ff => 4 * u64::from(word & 0x7f),
            // The wide push, its registers in the second half.
            0xe92d => 4 * u64::from(words.next().unwrap_or(0).count_ones()),
            // A frame pointer.
            0xaf00..=0xafff => 0,
            _ => break,
        };
    }
    frame
}

/// The section's pairs: an address of 4 bytes, and a size in the variable length of
/// DWARF.
fn frames(section: &[u8]) -> HashMap<u64, u64> {
    let mut frames = HashMap::new();
    let mut bytes = section.iter().copied();
    while let Some(first) = bytes.next() {
        let mut rest = || bytes.next().unwrap_or(0);
        let start = u32::from_le_bytes([first, rest(), rest(), rest()]);
        let (mut frame, mut shift) = (0, 0);
        loop {
            let byte = rest();
            frame |= u64::from(byte & 0x7f) << shift;
            shift += 7;
            if byte & 0x80 == 0 {
                break;
            }
        }
        frames.insert(address(start.into()), frame);
    }
    frames
}
