import { MORE_PUMPS, PUMPS } from "../tests/growth/pumps.ts";
import { READERS } from "../tests/growth/readers.ts";
import { STORED } from "../tests/growth/stored-readers.ts";

/** A text of an eighth of the length takes an eighth of the time where a reader is linear; from this ratio on it is listed. */
const LISTED = 20;
/** Shorter times are noise, milliseconds. */
const LEAST = 15;

/** Least processor time of some tries, milliseconds. */
function timed(read: () => unknown, tries: number): number {
  let least = Infinity;
  for (let i = 0; i < tries; i += 1) {
    const started = process.cpuUsage();
    try {
      read();
    } catch (error) {
      console.log(`throws: ${String(error).slice(0, 120)}`);
    }
    const { user, system } = process.cpuUsage(started);
    least = Math.min(least, (user + system) / 1000);
    if (least > 500) break;
  }
  return least;
}

/** `npm run growth [CHARACTERS] [READER]`: every reader on every repeated text, and which of them grow faster than it. */
export function main([size = "32000", only]: readonly string[]): number {
  const whole = Number(size);
  let [tried, listed] = [0, 0];
  for (const { name, read, frames = [], pumps = [] } of [...READERS, ...STORED]) {
    if (only !== undefined && !name.startsWith(only)) continue;
    for (const [front, behind] of [["", ""], ["", "!"], ...frames] as const)
      for (const pump of [...PUMPS, ...MORE_PUMPS, ...pumps]) {
        const of = (length: number) => {
          const text = front + pump.repeat(Math.ceil(length / pump.length)) + behind;
          return () => read(text);
        };
        tried += 1;
        const part = timed(of(whole / 8), 1);
        const all = part > 500 ? part * 64 : timed(of(whole), 1);
        if (all < LEAST || all < LISTED * part) continue;
        const [less, more] = [timed(of(whole / 8), 4), all > 500 ? all : timed(of(whole), 3)];
        if (more < LEAST || more < LISTED * less) continue;
        listed += 1;
        console.log(
          `${String(Math.round(more)).padStart(8)} ms ×${(more / less).toFixed(0)} ${name} ${JSON.stringify([front, pump, behind])}`,
        );
      }
  }
  console.log(
    `${READERS.length + STORED.length} readers, ${tried} texts of ${whole} characters, ${listed} that grow faster than their text`,
  );
  // Modules of the page open a message port, which would keep the process waiting.
  process.stdout.write("", () => process.exit());
  return 0;
}
