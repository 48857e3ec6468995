//! The promises of the crate, with a module for each. Oracles and sets of cases are in the package
//! `septum-kit`, `tests/kit/`.

mod any_bits;

// The source.
mod imports;

// Shapes: valid and invalid input.
mod bounds;
mod construction;
mod generic;
mod rotations;

// Triangle against axis-aligned box: the exact verdict.
mod contact;
mod degenerate;
mod every_size;
mod exact_oracle;
mod exhaustive_grid;
mod extremes;
mod near_miss;
mod symmetry;
mod thirteen_axes;

// The same: the conservative verdict, and the separating axis.
mod axis_vector;
mod conservative;
mod witness;

// Other shapes against boxes, and flat shapes against triangles.
mod capsules;
mod contacts;
mod crossings;
mod flat_shapes;
mod in_vain;
mod line_obb;
mod moving_spheres;
mod obb;
mod oriented_boxes;
mod oriented_pairs;
mod plane;
mod polygons;
mod prepared_rays;
mod ray_box;
mod ray_box_rounded;
mod relations;
mod residues;
mod segment_box;
mod small_pairs;
mod spheres;
mod sweep;

// Ray against triangle.
mod exhaustive_rays;
mod hit_order;
mod ray_rounding;
mod ray_triangle;
mod rounded_rays;
mod watertight;

// Whole meshes and many boxes: the answers of their triangles and boxes, one by one.
mod broad_phase;
mod mesh;

// Cases from users of other libraries.
mod published_cases;
mod published_pairs;

// Unit normals.
mod unit_normal;

// Lanes.
mod lanes;

// The same bits on every machine.
mod determinism;

// Other crates' types, and results of bounded size.
mod bounded;
mod interop;
mod logging;

// The main job and the other examples, run as a user runs them.
mod examples;
mod voxel;
mod voxel_lines;
mod voxel_sets;

// The oracles themselves.
mod oracle;
mod ray_oracle;
