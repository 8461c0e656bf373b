import { stopwatch } from "../base/clock.ts";

let until = 0;

/**
 * The operator types in a program: what comes of it is taken in after a pause, ms, in which half of a word is no fault
 * yet.
 */
export function typingGoesOn(pause: number): void {
  until = stopwatch() + pause;
}

/** Resolves at the next pause in typing; at once where nobody types. */
export async function pauseInTyping(): Promise<void> {
  for (let rest = until - stopwatch(); rest > 0; rest = until - stopwatch())
    await new Promise((done) => setTimeout(done, rest));
}
