import { stopwatch } from "../clock.ts";

/** How long the page waits for a pause in typing before it takes in a large result, ms. */
const PAUSE = 600;

let until = 0;

/** The operator types in a long program: what takes time waits for a pause. */
export function typingGoesOn(): void {
  until = stopwatch() + PAUSE;
}

/** Resolves at the next pause in typing; at once where nobody types. */
export async function pauseInTyping(): Promise<void> {
  for (let rest = until - stopwatch(); rest > 0; rest = until - stopwatch())
    await new Promise((done) => setTimeout(done, rest));
}
