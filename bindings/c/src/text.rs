//! Answers in words, and the version.

use core::ffi::{CStr, c_char};

use crate::shapes::Answer;

/// An answer in words, for a log. It stays.
#[unsafe(no_mangle)]
pub extern "C" fn septum_text(answer: i32) -> *const c_char {
    let codes = [
        (Answer::No, c"no"),
        (Answer::Yes, c"yes"),
        (Answer::NullPointer, c"a pointer is null"),
        (Answer::NotFinite, c"a coordinate is NaN or infinite"),
        (Answer::NegativeHalfExtent, c"a half-extent is negative"),
        (Answer::MinAboveMax, c"the least corner of a box lies above its greatest"),
        (Answer::NotOrthonormal, c"the axes of a box are not unit vectors at right angles"),
        (Answer::ZeroDirection, c"the direction of a ray is zero"),
        (Answer::EmptyRange, c"a range ends before it begins"),
        (Answer::NoSuchVertex, c"a triangle of the mesh refers to a vertex that does not exist"),
        (Answer::WrongNodeCount, c"the mesh has the wrong number of nodes for its tree"),
        (Answer::BrokenTree, c"a box of the tree does not enclose everything below it"),
        (Answer::NotOpen, c"the tree was not opened"),
        (Answer::TooManyTriangles, c"the mesh has more triangles than its indices can number"),
        (Answer::NoRange, c"the ray has the range [0, 0]: set t_max"),
        (Answer::NegativeRadius, c"a radius is negative"),
        (Answer::NotUnitQuaternion, c"the quaternion has not the length one"),
    ];
    let text: Option<&(Answer, &CStr)> = codes.iter().find(|(code, _)| *code as i32 == answer);
    text.map_or(c"not an answer of septum", |(_, text)| text).as_ptr()
}
