//! The module's memory: slots, a list that grows, and the numbers of answers.

use alloc::vec::Vec;
use core::sync::atomic::{AtomicU32, Ordering};

use spin::{Mutex, MutexGuard};

/// Things by their handles.
pub(crate) struct Slots<T>(Vec<Option<T>>);

impl<T> Slots<T> {
    pub(crate) const EMPTY: Self = Self(Vec::new());

    /// Keeps a thing, and returns its handle.
    pub(crate) fn keep(&mut self, thing: T) -> i32 {
        let free = self.0.iter().position(Option::is_none).unwrap_or_else(|| {
            self.0.push(None);
            self.0.len() - 1
        });
        self.0[free] = Some(thing);
        free as i32
    }

    pub(crate) fn get(&self, handle: usize) -> Option<&T> {
        self.0.get(handle)?.as_ref()
    }

    pub(crate) fn get_mut(&mut self, handle: usize) -> Option<&mut T> {
        self.0.get_mut(handle)?.as_mut()
    }

    /// Puts a thing in place of one that was taken.
    pub(crate) fn put(&mut self, handle: usize, thing: T) {
        if let Some(slot) = self.0.get_mut(handle) {
            *slot = Some(thing);
        }
    }

    pub(crate) fn take(&mut self, handle: usize) -> Option<T> {
        self.0.get_mut(handle)?.take()
    }
}

/// There is one thread, and each export locks once: a lock that is held is a panic's.
pub(crate) fn lock<T>(mutex: &'static Mutex<T>) -> MutexGuard<'static, T> {
    mutex.try_lock().unwrap_or_else(|| core::arch::wasm32::unreachable())
}

/// Whether there is memory for so many bytes at once. It stays with the module.
pub(crate) fn reaches(bytes: usize) -> bool {
    bytes < isize::MAX as usize && Vec::<u8>::new().try_reserve_exact(bytes).is_ok()
}

/// A table of so many elements, or `None` if there is no memory.
pub(crate) fn table<T: Clone>(element: T, length: usize) -> Option<Vec<T>> {
    let mut table = Vec::new();
    table.try_reserve_exact(length).ok()?;
    table.resize(length, element);
    Some(table)
}

/// The numbers of an answer, as bits.
static NUMBERS: [AtomicU32; 8] = [const { AtomicU32::new(0) }; 8];

#[unsafe(export_name = "numbers")]
extern "C" fn numbers() -> *const AtomicU32 {
    NUMBERS.as_ptr()
}

/// Writes an answer to the numbers from `first` on.
pub(crate) fn say(first: usize, answer: &[u32]) {
    for (number, &bits) in NUMBERS.iter().skip(first).zip(answer) {
        number.store(bits, Ordering::Relaxed);
    }
}

/// Many questions, and their answers; or an answer of any length.
pub(crate) static LIST: Mutex<Vec<u32>> = Mutex::new(Vec::new());

/// Makes the list this long, and returns its address, or null if there is no memory. With zero its
/// memory is given back.
#[unsafe(export_name = "list")]
extern "C" fn list(length: usize) -> *const u32 {
    let mut list = lock(&LIST);
    if length == 0 {
        *list = Vec::new();
    } else {
        let more = length.saturating_sub(list.len());
        if list.try_reserve_exact(more).is_err() {
            return core::ptr::null();
        }
        list.resize(length, 0);
    }
    list.as_ptr()
}

/// The address of the list.
#[unsafe(export_name = "found")]
extern "C" fn found() -> *const u32 {
    lock(&LIST).as_ptr()
}
