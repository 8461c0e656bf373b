/** A fault that can be put into a program, as it happens at machines. */
export const FAULT_KINDS = ["perRevolution", "minus", "tool", "start", "infeed", "limit"] as const;
export type FaultKind = (typeof FAULT_KINDS)[number];

type Put = (lines: readonly string[]) => readonly string[] | null;

/** Replaces the first line that matches a pattern. */
const inFirst =
  (pattern: RegExp, by: (...found: string[]) => string): Put =>
  (lines) => {
    const at = lines.findIndex((line) => pattern.test(line)),
      line = lines[at];
    return line === undefined ? null : lines.with(at, line.replace(pattern, by));
  };

/** The tip is inside the material at the cycle call. */
const startInside: Put = (lines) => {
  const call = lines.findIndex((line) => /\bCYCL CALL\b/.test(line));
  const at = lines.slice(0, Math.max(0, call)).findLastIndex((line) => /^\s*(?:\d+\s*)?L\s.*\bZ[+-]?[\d.]/.test(line)),
    line = lines[at];
  return line === undefined ? null : lines.with(at, line.replace(/\bZ[+-]?[\d.]+/, "Z-5"));
};

/** A number times a factor, as programs write it. */
const times = (text: string, by: number): string => String(Math.round(Number(text) * by * 1000) / 1000);

const PUT: Readonly<Record<FaultKind, Put>> = {
  perRevolution: (lines) => {
    const at = lines.findIndex((line) => /^\s*(?:\d+\s*)?M136\s*$/.test(line));
    return at < 0 ? null : lines.toSpliced(at, 1);
  },
  minus: inFirst(/\b(Q49[24])=-(\d[\d.]*)/, (_, q = "", value = "") => `${q}=+${value}`),
  tool: inFirst(/\bTOOL CALL (\d+)/, (_, tool = "") => `TOOL CALL ${tool === "3" ? 1 : 3}`),
  start: startInside,
  infeed: inFirst(/\bQ463=\+?(\d[\d.]*)/, (_, value = "") => `Q463=+${times(value, 4)}`),
  limit: inFirst(/\bSMAX:?(\d+)/, (_, value = "") => `SMAX${times(value, 3)}`),
};

/** The faults that can be put into a program. */
export const possibleFaults = (lines: readonly string[]): readonly FaultKind[] =>
  FAULT_KINDS.filter((kind) => PUT[kind](lines) !== null);

/** A program with faults; a fault that does not fit the program is left out. */
export const withFaults = (lines: readonly string[], kinds: readonly FaultKind[]): readonly string[] =>
  FAULT_KINDS.filter((kind) => kinds.includes(kind)).reduce((now, kind) => PUT[kind](now) ?? now, lines);
