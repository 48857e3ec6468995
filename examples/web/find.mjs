// Where the modules lie.

/** Beside this file, or where cargo puts them. */
const FOLDERS = ['', '../../target/wasm32-unknown-unknown/web/examples/'];

/**
 * What `take` makes of the bytes of the first module of that name that it takes, and how many they
 * are. Else `problem` says what is wrong with what lies there, if anything does.
 */
export async function find(name, take) {
    let problem = '';
    for (const place of FOLDERS.map((folder) => folder + name)) {
        try {
            const response = await fetch(new URL(place, import.meta.url));
            if (!response.ok) continue;
            const bytes = await response.arrayBuffer();
            return { module: await take(bytes), size: bytes.byteLength };
        } catch (error) {
            problem = `${place} was not taken: ${error.message}.`;
        }
    }
    return { module: null, problem };
}
