import { readNamedWords, readOutline } from "./read-frame.ts";
import type { Scan } from "./scan.ts";
import type { Statement } from "./statement.ts";
import { VALUE } from "./value.ts";

const MODE = /MODE[ \t]+(TURN|MILL)(?![A-Z])/iy;
const SPIN = /TURNDATA[ \t]+SPIN(?![A-Z])/iy;
const CORRECTION = /TURNDATA[ \t]+CORR[ \t]*-[ \t]*(TCS|WPL)[ \t]*:[ \t]*([A-Z](?:[ \t]*\/[ \t]*[A-Z])?)(?![A-Z])/iy;
const BLANK = /TURNDATA[ \t]+BLANK(?![A-Z])/iy;
const QUOTED = /"([^"]*)"/y;
const VCONST = /VCONST[ \t]*:?[ \t]*(ON|OFF)(?![A-Z])/iy;
const value = (word: string) => new RegExp(String.raw`${word}[ \t]*:?[ \t]*(${VALUE})`, "iy");
const [VC, SMAX, S, GEAR] = [value("VC"), value("SMAX"), value("S"), value("GEARRANGE")] as const;

/** What follows FUNCTION; null when it is none of the functions of turning. */
export function readFunction(scan: Scan): Statement | null {
  const mode = scan.take(MODE);
  if (mode) {
    const name = scan.take(QUOTED);
    scan.leftOver();
    return { kind: "mode", mode: mode[1]?.toUpperCase() === "MILL" ? "MILL" : "TURN", kinematics: name?.[1] ?? null };
  }
  if (scan.take(SPIN)) return readSpin(scan);
  const correction = scan.take(CORRECTION);
  if (correction) {
    const plane = (correction[2] ?? "").replace(/[ \t]/g, "").toUpperCase();
    return {
      kind: "turnCorrection",
      system: correction[1]?.toUpperCase() === "WPL" ? "WPL" : "TCS",
      plane,
      words: readNamedWords(scan),
    };
  }
  if (!scan.take(BLANK)) return null;
  const blank = readOutline(scan);
  if (blank) return { kind: "turnBlank", blank };
  return scan.take(/OFF(?![A-Z])/iy) ? { kind: "turnBlank", blank: "off" } : null;
}

function readSpin(scan: Scan): Statement {
  const constant = scan.take(VCONST);
  if (!constant) scan.missing("VCONST");
  const spin = {
    cuttingSpeed: null as ReturnType<Scan["value"]>,
    speed: null as ReturnType<Scan["value"]>,
    limit: null as ReturnType<Scan["value"]>,
  };
  let gear: ReturnType<Scan["value"]> = null;
  for (;;) {
    let m: RegExpExecArray | null;
    if ((m = scan.take(VC))) spin.cuttingSpeed = scan.value(m[1] ?? "");
    else if ((m = scan.take(SMAX))) spin.limit = scan.value(m[1] ?? "");
    else if ((m = scan.take(S))) spin.speed = scan.value(m[1] ?? "");
    else if ((m = scan.take(GEAR))) gear = scan.value(m[1] ?? "");
    else break;
  }
  scan.leftOver();
  return {
    kind: "spin",
    constantSurface: constant?.[1]?.toUpperCase() === "ON",
    ...spin,
    ...(gear !== null && { gear }),
  };
}
