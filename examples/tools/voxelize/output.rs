//! The files to write. The extension decides the format.

use std::error::Error;
use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

use crate::options::Options;

/// What a file holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Format {
    Picture,
    /// A MagicaVoxel model.
    Vox,
    /// A NumPy array.
    Npy,
    Bits,
    /// An OBJ file of cubes.
    Cubes,
}

impl Format {
    fn of(path: &Path) -> Result<Self, String> {
        let extension =
            path.extension().map_or(String::new(), |e| e.to_string_lossy().to_lowercase());
        Ok(match extension.as_str() {
            "png" => Self::Picture,
            "vox" => Self::Vox,
            "npy" => Self::Npy,
            "bits" => Self::Bits,
            "obj" => Self::Cubes,
            _ => {
                let path = path.display();
                return Err(format!(
                    "{path}: the extension says what to write: .png, .vox, .npy, .bits or .obj"
                ));
            }
        })
    }

    /// The name in the report.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Picture => "picture",
            Self::Vox => "model",
            Self::Npy => "array",
            Self::Bits => "bits",
            Self::Cubes => "cubes",
        }
    }
}

/// A file to write.
pub(crate) struct Output {
    pub(crate) path: PathBuf,
    pub(crate) format: Format,
}

impl Output {
    /// The files that the options ask for; a picture if they name none.
    pub(crate) fn all(options: &Options, mesh: &str) -> Result<Vec<Self>, String> {
        let mut paths = options.output.clone();
        if paths.is_empty() && !options.no_picture {
            paths.push(Path::new("out").join(format!("{mesh}.png")));
        }
        let of = |path: PathBuf| Ok(Self { format: Format::of(&path)?, path });
        let mut outputs = paths.into_iter().map(of).collect::<Result<Vec<_>, String>>()?;
        if let Some(path) = options.vox.clone() {
            let model = of(path)?;
            if model.format != Format::Vox {
                return Err(format!("{}: --vox writes a .vox file", model.path.display()));
            }
            outputs.push(model);
        }
        let has_picture = outputs.iter().any(|output| output.format == Format::Picture);
        for (is_set, name) in [(options.cut, "--cut"), (options.compare.is_some(), "--compare")] {
            if is_set && !has_picture {
                return Err(format!("{name}: only a picture shows it: --output FILE.png"));
            }
        }
        Ok(outputs)
    }

    /// Opens all files, before the work begins.
    pub(crate) fn open(
        outputs: Vec<Self>,
        meshes: &[PathBuf],
    ) -> Result<Vec<Open>, Box<dyn Error>> {
        let place = |path: &Path| path.canonicalize().ok();
        let meshes: Vec<_> = meshes.iter().filter_map(|mesh| place(mesh)).collect();
        let mut opened: Vec<Open> = Vec::new();
        for output in outputs {
            let path = output.path.display();
            let in_file = |e: std::io::Error| format!("{path}: cannot be written: {e}");
            if place(&output.path).is_some_and(|place| meshes.contains(&place)) {
                return Err(format!("{path}: is the mesh itself").into());
            }
            if let Some(directory) = output.path.parent() {
                fs::create_dir_all(directory).map_err(in_file)?;
            }
            let file = File::create(&output.path).map_err(in_file)?;
            if opened.iter().any(|other| place(&other.output.path) == place(&output.path)) {
                return Err(format!("{path}: is to be written twice").into());
            }
            opened.push(Open { file, output });
        }
        Ok(opened)
    }
}

/// A file that is open.
pub(crate) struct Open {
    file: File,
    pub(crate) output: Output,
}

impl Open {
    pub(crate) fn write(
        self,
        content: impl FnOnce(&mut BufWriter<File>) -> Result<(), Box<dyn Error>>,
    ) -> Result<(), String> {
        let mut file = BufWriter::new(self.file);
        content(&mut file)
            .and_then(|()| Ok(file.flush()?))
            .map_err(|e| format!("{}: cannot be written: {e}", self.output.path.display()))
    }
}
