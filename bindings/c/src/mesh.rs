//! A mesh and its tree in the caller's memory, and queries on them.

use core::marker::PhantomData;
use core::mem::{align_of, size_of};
use core::slice;

use septum::Vec3;
use septum::mesh::{self, Index, MeshError, Node, Probe};

use crate::number::Number;
use crate::queries::by;
use crate::shapes::{
    Aabb, Answer, Closest, FirstContact, Hit, Ray, Shape, Sphere, SphereContact, point,
};

/// A closed mesh and the nodes of its tree, for example in flash. Triangles are indices of
/// vertices; with nodes they are listed in the tree's order. The program in examples/pick writes such
/// tables.
#[repr(C)]
pub struct Mesh<T, I> {
    pub vertices: *const [T; 3],
    pub vertex_count: usize,
    pub triangles: *const [I; 3],
    pub triangle_count: usize,
    pub nodes: *const [[u16; 4]; 6],
    pub node_count: usize,
}

/// A mesh that has been checked. Only `septum_tree_open` and `septum_tree_build` write one. It may
/// be copied, but the mesh must stay where it is.
#[repr(C)]
pub struct Tree<T, I> {
    /// Private to the library.
    pub opaque: [u64; 32],
    pub numbers: PhantomData<T>,
    pub indices: PhantomData<I>,
}

pub(crate) type Opened<T, I> = mesh::Tree<'static, <T as Number>::Scalar, I>;

/// The contents of a [`Tree`]: first a mark that is not zero, so that a tree of zeros is not open. Each
/// type of numbers and of indices has its own, so that a tree of one is not open as one of another.
#[repr(C)]
struct Kept<T: Number, I: Index> {
    mark: u64,
    tree: Opened<T, I>,
}

impl<T: Number, I: Index> Kept<T, I> {
    const MARK: u64 = 0x7365_7074_756d_0000 | (size_of::<I>() as u64) << 8 | T::TAG as u64;
    const FITS: () = assert!(
        size_of::<Self>() <= size_of::<Tree<T, I>>()
            && align_of::<Self>() <= align_of::<Tree<T, I>>()
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
/// The vertices and triangles are as many as the mesh says, and stay.
unsafe fn mesh_of<T: Number, I: Index>(
    mesh: Option<&Mesh<T, I>>,
) -> Result<mesh::Mesh<'static, T::Scalar, I>, Answer> {
    let Some(mesh) = mesh else { return Err(Answer::NullPointer) };
    if mesh.vertices.is_null() || mesh.triangles.is_null() {
        return Err(Answer::NullPointer);
    }
    // SAFETY: no pointer is null, and each slice is as long as the caller says. A `Vec3` is three
    // numbers in C's order, and a scalar has the bits that `Number` says.
    let (vertices, triangles) = unsafe {
        (
            slice::from_raw_parts(mesh.vertices.cast::<Vec3<T::Scalar>>(), mesh.vertex_count),
            slice::from_raw_parts(mesh.triangles, mesh.triangle_count),
        )
    };
    Ok(mesh::Mesh::new(vertices, triangles)?)
}

/// # Safety
/// The tree is not null, and has room.
unsafe fn keep<T: Number, I: Index>(
    opened: Result<Opened<T, I>, MeshError>,
    tree: *mut Tree<T, I>,
) -> Answer {
    let () = Kept::<T, I>::FITS;
    match opened {
        Ok(opened) => {
            let kept = Kept { mark: Kept::<T, I>::MARK, tree: opened };
            // SAFETY: the pointer is not null, and `FITS` compared size and alignment.
            unsafe { tree.cast::<Kept<T, I>>().write(kept) };
            Answer::Yes
        }
        Err(error) => error.into(),
    }
}

/// # Safety
/// Each pointer of the mesh leads to as many elements as the mesh says, for as long as the tree is
/// used.
pub(crate) unsafe fn open<T: Number, I: Index>(
    mesh: Option<&Mesh<T, I>>,
    tree: *mut Tree<T, I>,
) -> Answer {
    let Some(given) = mesh else { return Answer::NullPointer };
    if tree.is_null() || given.nodes.is_null() {
        return Answer::NullPointer;
    }
    // SAFETY: as the caller promises; a node is its bits.
    unsafe {
        let nodes = slice::from_raw_parts(given.nodes.cast::<Node>(), given.node_count);
        match mesh_of(mesh) {
            Ok(mesh) => keep(mesh::Tree::new(mesh, nodes), tree),
            Err(error) => error,
        }
    }
}

/// # Safety
/// As for [`open`]; `nodes` and `order` are as long as is said.
pub(crate) unsafe fn build<T: Number, I: Index>(
    mesh: Option<&Mesh<T, I>>,
    nodes: *mut [[u16; 4]; 6],
    node_count: usize,
    order: *mut I,
    tree: *mut Tree<T, I>,
) -> Answer {
    if tree.is_null() || nodes.is_null() || order.is_null() {
        return Answer::NullPointer;
    }
    // SAFETY: as the caller promises.
    let mesh = match unsafe { mesh_of(mesh) } {
        Ok(mesh) => mesh,
        Err(error) => return error,
    };
    let count = mesh.triangles().len();
    // SAFETY: as the caller promises. All bits are a node, and all numbers an index.
    unsafe {
        let nodes = slice::from_raw_parts_mut(nodes.cast::<Node>(), node_count);
        let order = slice::from_raw_parts_mut(order, count);
        keep(mesh::Tree::build(mesh, nodes, order), tree)
    }
}

/// How many nodes the tree over so many triangles has.
#[unsafe(no_mangle)]
pub extern "C" fn septum_node_count(triangles: usize) -> usize {
    Node::count_for(triangles)
}

/// # Safety
/// The tree is zero, or was written by [`keep`], and its mesh stays.
pub(crate) unsafe fn opened<T: Number, I: Index>(
    tree: Option<&Tree<T, I>>,
) -> Result<&Opened<T, I>, Answer> {
    let Some(tree) = tree else { return Err(Answer::NullPointer) };
    if tree.opaque[0] != Kept::<T, I>::MARK {
        return Err(Answer::NotOpen);
    }
    // SAFETY: the mark says that `keep` wrote it.
    Ok(unsafe { &(*core::ptr::from_ref(tree).cast::<Kept<T, I>>()).tree })
}

/// A point with finite coordinates.
fn finite<T: Number>(p: &[T; 3]) -> Result<[T::Scalar; 3], Answer> {
    let p = point(p);
    if p.iter().all(|&x| septum::Scalar::is_finite(x)) { Ok(p) } else { Err(Answer::NotFinite) }
}

/// # Safety
/// As for [`opened`].
pub(crate) unsafe fn contains<T: Number, I: Index>(
    tree: Option<&Tree<T, I>>,
    p: Option<&[T; 3]>,
) -> Answer {
    let Some(p) = p else { return Answer::NullPointer };
    // SAFETY: as the caller promises.
    let contains = unsafe { opened(tree) }.and_then(|tree| Ok(tree.contains(finite(p)?)));
    contains.map_or_else(|error| error, Answer::from)
}

/// What `ask` finds, written to its places.
///
/// # Safety
/// As for [`opened`].
unsafe fn find<T: Number, I: Index, R, C: From<R>>(
    tree: Option<&Tree<T, I>>,
    triangle: Option<&mut usize>,
    place: Option<&mut C>,
    ask: impl FnOnce(&Opened<T, I>) -> Result<Option<(usize, R)>, Answer>,
) -> Answer {
    let (Some(triangle), Some(place)) = (triangle, place) else { return Answer::NullPointer };
    // SAFETY: as the caller promises.
    match unsafe { opened(tree) }.and_then(ask) {
        Err(error) => error,
        Ok(None) => Answer::No,
        Ok(Some((i, found))) => {
            *triangle = i;
            *place = found.into();
            Answer::Yes
        }
    }
}

/// # Safety
/// As for [`opened`].
pub(crate) unsafe fn first_hit<T: Number, I: Index>(
    tree: Option<&Tree<T, I>>,
    ray: Option<&Ray<T>>,
    triangle: Option<&mut usize>,
    hit: Option<&mut Hit<T>>,
) -> Answer {
    let Some(ray) = ray else { return Answer::NullPointer };
    // SAFETY: as the caller promises.
    unsafe { find(tree, triangle, hit, |tree| Ok(tree.first_hit(&ray.shape()?))) }
}

/// # Safety
/// As for [`opened`].
pub(crate) unsafe fn is_hit<T: Number, I: Index>(
    tree: Option<&Tree<T, I>>,
    ray: Option<&Ray<T>>,
) -> Answer {
    let Some(ray) = ray else { return Answer::NullPointer };
    // SAFETY: as the caller promises.
    let hit = unsafe { opened(tree) }.and_then(|tree| Ok(tree.is_hit(&ray.shape()?)));
    hit.map_or_else(|error| error, Answer::from)
}

/// # Safety
/// As for [`opened`].
pub(crate) unsafe fn overlapping<T: Number, I: Index, S>(
    tree: Option<&Tree<T, I>>,
    shape: Option<&S>,
    triangle: Option<&mut usize>,
) -> Answer
where
    S: Shape<Of: Probe<T::Scalar>>,
{
    let Some(shape) = shape else { return Answer::NullPointer };
    // SAFETY: as the caller promises.
    unsafe {
        find(tree, triangle, Some(&mut ()), |tree| {
            Ok(tree.overlapping(&shape.shape()?).next().map(|i| (i, ())))
        })
    }
}

/// # Safety
/// As for [`opened`].
pub(crate) unsafe fn closest_point<T: Number, I: Index>(
    tree: Option<&Tree<T, I>>,
    p: Option<&[T; 3]>,
    triangle: Option<&mut usize>,
    closest: Option<&mut Closest<T>>,
) -> Answer {
    let Some(p) = p else { return Answer::NullPointer };
    // SAFETY: as the caller promises.
    unsafe { find(tree, triangle, closest, |tree| Ok(tree.closest_point(finite(p)?))) }
}

/// # Safety
/// As for [`opened`].
pub(crate) unsafe fn aabb_cast<T: Number, I: Index>(
    tree: Option<&Tree<T, I>>,
    aabb: Option<&Aabb<T>>,
    motion: Option<&[T; 3]>,
    triangle: Option<&mut usize>,
    first: Option<&mut FirstContact<T>>,
) -> Answer {
    let (Some(aabb), Some(motion)) = (aabb, motion) else { return Answer::NullPointer };
    // SAFETY: as the caller promises.
    unsafe {
        find(tree, triangle, first, |tree| {
            let motion = by(motion)?;
            let first = tree.first_contact(&aabb.shape()?, &motion);
            Ok(first.and_then(|(i, first)| Some((i, (first, motion, tree.mesh().triangle(i)?)))))
        })
    }
}

/// # Safety
/// As for [`opened`].
pub(crate) unsafe fn sphere_cast<T: Number, I: Index>(
    tree: Option<&Tree<T, I>>,
    sphere: Option<&Sphere<T>>,
    motion: Option<&[T; 3]>,
    triangle: Option<&mut usize>,
    first: Option<&mut SphereContact<T>>,
) -> Answer {
    let (Some(sphere), Some(motion)) = (sphere, motion) else { return Answer::NullPointer };
    // SAFETY: as the caller promises.
    unsafe {
        find(tree, triangle, first, |tree| Ok(tree.first_contact(&sphere.shape()?, &by(motion)?)))
    }
}
