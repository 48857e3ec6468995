//! A mesh and its tree in the caller's memory, and queries on them.

use core::marker::PhantomData;
use core::mem::{align_of, size_of};
use core::slice;

use septum::Vec3;
use septum::mesh::{self, MeshError, Node};

use crate::number::{I8F8, I16F16, Number};
use crate::shapes::Answer;

/// A closed mesh and the nodes of its tree, for example in flash. Triangles are indices of
/// vertices, and are listed in the tree's order. septum's example `quantise` writes such tables.
#[repr(C)]
pub struct Mesh<T> {
    pub vertices: *const [T; 3],
    pub vertex_count: usize,
    pub triangles: *const [u16; 3],
    pub triangle_count: usize,
    pub nodes: *const [[u16; 4]; 6],
    pub node_count: usize,
}

/// A mesh that has been checked. Only `septum_tree_open` writes one. It may be copied, but the mesh
/// must stay where it is.
#[repr(C)]
pub struct Tree<T> {
    /// Private to the library.
    pub opaque: [u64; 24],
    pub numbers: PhantomData<T>,
}

type Opened<T> = mesh::Tree<'static, <T as Number>::Scalar, u16>;

/// The contents of a [`Tree`]: first a mark that is not zero, so that a tree of zeros is not open.
#[repr(C)]
struct Kept<T: Number> {
    mark: u64,
    tree: Opened<T>,
}

impl<T: Number> Kept<T> {
    const MARK: u64 = 0x7365_7074_756d_0000 | size_of::<T>() as u64;
    const FITS: () = assert!(
        size_of::<Self>() <= size_of::<Tree<T>>() && align_of::<Self>() <= align_of::<Tree<T>>()
    );
}

impl From<MeshError> for Answer {
    fn from(error: MeshError) -> Self {
        match error {
            MeshError::NotFinite { .. } => Self::NotFinite,
            MeshError::Length { .. } => Self::WrongNodeCount,
            MeshError::Node { .. } => Self::BrokenTree,
            MeshError::TooManyTriangles => Self::TooManyTriangles,
            _ => Self::NoSuchVertex,
        }
    }
}

/// # Safety
/// Each pointer of the mesh leads to as many elements as the mesh says, for as long as the tree is
/// used.
unsafe fn open<T: Number>(mesh: Option<&Mesh<T>>, tree: *mut Tree<T>) -> Answer {
    let () = Kept::<T>::FITS;
    let Some(mesh) = mesh else { return Answer::NullPointer };
    if tree.is_null() || mesh.vertices.is_null() || mesh.triangles.is_null() || mesh.nodes.is_null()
    {
        return Answer::NullPointer;
    }
    // SAFETY: no pointer is null, and each slice is as long as the caller says. A `Vec3` is three
    // numbers in C's order, a scalar has the bits that `Number` says, and a node is its bits.
    let (vertices, triangles, nodes) = unsafe {
        (
            slice::from_raw_parts(mesh.vertices.cast::<Vec3<T::Scalar>>(), mesh.vertex_count),
            slice::from_raw_parts(mesh.triangles, mesh.triangle_count),
            slice::from_raw_parts(mesh.nodes.cast::<Node>(), mesh.node_count),
        )
    };
    let opened = mesh::Mesh::new(vertices, triangles).and_then(|mesh| mesh::Tree::new(mesh, nodes));
    match opened {
        Ok(opened) => {
            // SAFETY: the pointer is not null, and `FITS` compared size and alignment.
            unsafe { tree.cast::<Kept<T>>().write(Kept { mark: Kept::<T>::MARK, tree: opened }) };
            Answer::Yes
        }
        Err(error) => error.into(),
    }
}

/// # Safety
/// The tree is zero, or was written by [`open`].
unsafe fn contains<T: Number>(tree: Option<&Tree<T>>, point: Option<&[T; 3]>) -> Answer {
    let (Some(tree), Some(point)) = (tree, point) else { return Answer::NullPointer };
    if tree.opaque[0] != Kept::<T>::MARK {
        return Answer::NotOpen;
    }
    // SAFETY: the mark says that `open` wrote it.
    let kept = unsafe { &*core::ptr::from_ref(tree).cast::<Kept<T>>() };
    let point = point.map(T::scalar);
    if !point.iter().all(|x| septum::Scalar::is_finite(*x)) {
        return Answer::NotFinite;
    }
    kept.tree.contains(point).into()
}

/// Checks a mesh and its tree, once: yes, or the error. `tree` is written only if the answer is
/// yes.
///
/// # Safety
/// Each pointer of the mesh leads to as many elements as the mesh says, for as long as the tree is
/// used.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn septum_tree_open_i8f8(
    mesh: Option<&Mesh<I8F8>>,
    tree: *mut Tree<I8F8>,
) -> Answer {
    // SAFETY: as the caller promises.
    unsafe { open(mesh, tree) }
}

/// Checks a mesh and its tree, once: yes, or the error. `tree` is written only if the answer is
/// yes.
///
/// # Safety
/// Each pointer of the mesh leads to as many elements as the mesh says, for as long as the tree is
/// used.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn septum_tree_open_i16f16(
    mesh: Option<&Mesh<I16F16>>,
    tree: *mut Tree<I16F16>,
) -> Answer {
    // SAFETY: as the caller promises.
    unsafe { open(mesh, tree) }
}

/// Checks a mesh and its tree, once: yes, or the error. `tree` is written only if the answer is
/// yes.
///
/// # Safety
/// Each pointer of the mesh leads to as many elements as the mesh says, for as long as the tree is
/// used.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn septum_tree_open_f32(
    mesh: Option<&Mesh<f32>>,
    tree: *mut Tree<f32>,
) -> Answer {
    // SAFETY: as the caller promises.
    unsafe { open(mesh, tree) }
}

/// Whether a closed mesh contains a point, exactly: inside, or on a triangle.
///
/// # Safety
/// The tree is zero, or was written by `septum_tree_open_i8f8`, and its mesh has not moved.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn septum_contains_i8f8(
    tree: Option<&Tree<I8F8>>,
    point: Option<&[I8F8; 3]>,
) -> Answer {
    // SAFETY: as the caller promises.
    unsafe { contains(tree, point) }
}

/// Whether a closed mesh contains a point, exactly: inside, or on a triangle.
///
/// # Safety
/// The tree is zero, or was written by `septum_tree_open_i16f16`, and its mesh has not moved.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn septum_contains_i16f16(
    tree: Option<&Tree<I16F16>>,
    point: Option<&[I16F16; 3]>,
) -> Answer {
    // SAFETY: as the caller promises.
    unsafe { contains(tree, point) }
}

/// Whether a closed mesh contains a point, exactly: inside, or on a triangle.
///
/// # Safety
/// The tree is zero, or was written by `septum_tree_open_f32`, and its mesh has not moved.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn septum_contains_f32(
    tree: Option<&Tree<f32>>,
    point: Option<&[f32; 3]>,
) -> Answer {
    // SAFETY: as the caller promises.
    unsafe { contains(tree, point) }
}
