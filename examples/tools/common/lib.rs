//! What the programs for users share: the command line, and reading meshes.

#[path = "../../shared/cli.rs"]
pub mod cli;
mod gltf;
pub mod mesh;
mod obj;
mod ply;
mod stl;
