//! Contacts of a shape with a mesh, in the caller's memory.

use core::slice;

use septum::Triangle;
use septum::contact::{ContactWith, InteriorEdges, contact_in_mesh, interior_edges};
use septum::mesh::{Index, Probe};

use crate::mesh::{Tree, opened};
use crate::number::Number;
use crate::shapes::{Answer, Contact, Shape};

/// The scratch memory has a triangle and an edge in each entry, and a byte is a set of edges.
const fn fit<I>() {
    assert!(
        size_of::<(I, u8)>() <= size_of::<[I; 2]>() && align_of::<(I, u8)>() <= align_of::<I>()
    );
    assert!(size_of::<InteriorEdges>() == size_of::<u8>());
}

/// # Safety
/// As for [`opened`]; `scratch` has three elements for each triangle, and `interior` one.
pub(crate) unsafe fn edges<T: Number, I: Index>(
    tree: Option<&Tree<T, I>>,
    scratch: *mut [I; 2],
    interior: *mut u8,
) -> Answer {
    const { fit::<I>() };
    if scratch.is_null() || interior.is_null() {
        return Answer::NullPointer;
    }
    // SAFETY: as the caller promises.
    let mesh = match unsafe { opened(tree) } {
        Ok(tree) => tree.mesh(),
        Err(error) => return error,
    };
    let count = mesh.triangles().len();
    // SAFETY: as the caller promises. All bits are an index and a byte, and all bytes a set.
    let (scratch, interior) = unsafe {
        (
            slice::from_raw_parts_mut(scratch.cast::<(I, u8)>(), 3 * count),
            slice::from_raw_parts_mut(interior.cast::<InteriorEdges>(), count),
        )
    };
    interior_edges(mesh, scratch, interior).map_or_else(Answer::from, |()| Answer::Yes)
}

/// # Safety
/// As for [`opened`]; `interior` is null or has an element for each triangle, and there is room for
/// `count` triangles and contacts.
pub(crate) unsafe fn contacts<T: Number, I: Index, S>(
    tree: Option<&Tree<T, I>>,
    shape: Option<&S>,
    interior: *const u8,
    triangles: *mut usize,
    contacts: *mut Contact<T>,
    count: Option<&mut usize>,
) -> Answer
where
    S: Shape<Of: Probe<T::Scalar>>,
    Triangle<T::Scalar>: ContactWith<T::Scalar, S::Of>,
{
    const { fit::<I>() };
    let (Some(shape), Some(count)) = (shape, count) else { return Answer::NullPointer };
    if *count > 0 && (triangles.is_null() || contacts.is_null()) {
        return Answer::NullPointer;
    }
    // SAFETY: as the caller promises.
    let (tree, shape) = match (unsafe { opened(tree) }, shape.shape()) {
        (Ok(tree), Ok(shape)) => (tree, shape),
        (Err(error), _) | (_, Err(error)) => return error,
    };
    let mut found = 0;
    for i in tree.overlapping(&shape) {
        let edges = if interior.is_null() {
            InteriorEdges::NONE
        } else {
            // SAFETY: it has an element for each triangle, and all bytes are a set.
            unsafe { interior.cast::<InteriorEdges>().add(i).read() }
        };
        let Some(triangle) = tree.mesh().triangle(i) else { continue };
        let Some(contact) = contact_in_mesh(&triangle, edges, &shape) else { continue };
        if found < *count {
            // SAFETY: the caller promises this room.
            unsafe {
                triangles.add(found).write(i);
                contacts.add(found).write(contact.into());
            }
        }
        found += 1;
    }
    *count = found;
    (found > 0).into()
}
