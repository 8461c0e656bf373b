import type { Shape } from "../shape.ts";

export const dialog = {
  title: (cycle: number, name: string) => `Cycle ${cycle} ${name}`,
  form: "Prompts of the cycle",
  list: "All prompts",
  active: "Active prompt",
  aboutPrompt: (q: string) => `About ${q}`,
  position: (n: number, of: number) => `${n} of ${of}`,
  value: (q: string, label: string) => `${q} ${label}`,
  row: (q: string, label: string, value: string) => `${q} ${label}: ${value}`,
  noValue: "not set",
  noEntry: "no entry",
  auto: "FAUTO",
  autoLong: "FAUTO: take the feed of the tool call",
  range: (min: string, max: string) => `${min} to ${max}`,
  rangeLabel: "Range",
  optional: "optional",
  incremental: "incremental",
  reserved: "reserved, no function here",
  units: {
    diameter: "mm ⌀", radius: "mm r", axial: "mm", degrees: "°", perRevolution: "mm/rev", perMinute: "mm/min", none: "",
  },
  diameterMeaning: "A diameter",
  radiusMeaning: "On the radius",
  evidence: {
    mark: "not confirmed",
    range: "This range is recalled or inferred, not checked against a printed page. Your control may allow another one.",
    parameter: "This parameter is recalled or inferred, not checked against a printed page. Verify it on your control.",
  },
  takeNearest: (value: string) => `Take ${value}`,
  keypad: "Keypad",
  keys: {
    enter: "ENT", enterLong: "ENT: take the value, next prompt",
    noEnter: "NO ENT", noEnterLong: "NO ENT: leave this prompt out",
    end: "END", endLong: "END: keep the rest as it is",
    sign: "±", signLong: "Change the sign",
    point: "Decimal point",
    erase: "⌫", eraseLong: "Erase one character",
    previous: "Previous prompt", next: "Next prompt",
    cancel: "Cancel: the value as it was",
  },
  help: "Enter: next · ↑ ↓: move · Del: NO ENT · End: END · Esc: cancel · −: sign",
  done: {
    title: "All prompts are answered",
    open: (n: number) => (n === 1 ? "1 prompt has no usable value" : `${n} prompts have no usable value`),
    first: "Back to the first prompt",
    firstOpen: "Go to it",
    copy: "Copy the program",
  },
};

export type DialogTexts = Shape<typeof dialog>;
