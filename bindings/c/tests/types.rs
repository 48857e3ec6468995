//! A tree is open only for the types of numbers and indices that it was opened with.

use core::ptr::{from_ref, null};

use septum_c::*;

#[test]
fn of_a_tree() {
    let vertices = [[0.0_f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let triangles = [[0_u16, 1, 2]];
    let mesh = Mesh {
        vertices: vertices.as_ptr(),
        vertex_count: 3,
        triangles: triangles.as_ptr(),
        triangle_count: 1,
        nodes: null(),
        node_count: 0,
    };
    let mut nodes = [[[0_u16; 4]; 6]];
    let mut order = [0_u16];
    let mut tree = Tree {
        opaque: [0; 32],
        numbers: core::marker::PhantomData,
        indices: core::marker::PhantomData,
    };
    let count = septum_node_count(1);
    assert!(count <= nodes.len());
    // SAFETY: each pointer leads to as many elements as is said. A tree is its words, whatever its types,
    // and one of other types is not looked at beyond the first.
    unsafe {
        assert_eq!(
            septum_tree_contains_f32(Some(&tree), [0.0; 3].as_ptr()),
            Answer::NotOpen,
            "of zeros"
        );
        let built = septum_tree_build_f32(
            Some(&mesh),
            nodes.as_mut_ptr(),
            count,
            order.as_mut_ptr(),
            &mut tree,
        );
        assert_eq!(built, Answer::Yes);
        assert_eq!(septum_tree_contains_f32(Some(&tree), [0.0; 3].as_ptr()), Answer::Yes);
        // As many bytes, of another type.
        let as_fixed = &*from_ref(&tree).cast();
        assert_eq!(septum_tree_contains_i16f16(Some(as_fixed), [0; 3].as_ptr()), Answer::NotOpen);
        let as_short = &*from_ref(&tree).cast();
        assert_eq!(septum_tree_contains_i8f8(Some(as_short), [0; 3].as_ptr()), Answer::NotOpen);
        let as_double = &*from_ref(&tree).cast();
        assert_eq!(septum_tree_contains_f64(Some(as_double), [0.0; 3].as_ptr()), Answer::NotOpen);
        let as_wide = &*from_ref(&tree).cast();
        assert_eq!(septum_tree32_contains_f32(Some(as_wide), [0.0; 3].as_ptr()), Answer::NotOpen);
    }
}
