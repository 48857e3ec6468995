// What the package says of numbers that it refuses.

/** An error of the package as a sentence; others are sentences. */
export function sentence(error) {
    if (!(error instanceof RangeError)) return error.message;
    return `${error.message[0].toUpperCase()}${error.message.slice(1)}.`;
}

/** What a question answers, or null beyond f32. */
export function orNull(ask) {
    try {
        return ask();
    } catch (error) {
        if (error instanceof RangeError) return null;
        throw error;
    }
}
