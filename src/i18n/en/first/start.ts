import type { Shape } from "../../shape.ts";

export const start = {
  hint: "Typing anywhere on this page searches, e.g. 812. Any of the four languages.",
  doors: {
    title: "Ways to start",
    guide: "Guide",
    glossary: "Glossary",
    program: "Program a cycle",
    programHow: "Answer the prompts as on the control; the lathe shows each value",
    openHow: "Klartext or DIN/ISO, to check, change by dialog and export",
    plan: "Working plan from the part",
  },
  hero: {
    name: (n: number) => `A shaft is machined in ${n} operations: the tool moves and removes material`,
    play: "Play",
    pause: "Pause",
    finish: "finishing",
    position: "positioning",
    proved: "verified",
    open: "Open this program",
    pass: (n: number, of: number) => `pass ${n} of ${of}`,
    facts: (operations: number, tools: number) => `${operations} operations · ${tools} tools`,
  },
  beyond: "Beyond the control",
  beyondAll: {
    values: {
      what: "Three values side by side",
      how: "one prompt with a small, a default and a large value, all simulated",
    },
    steps: { what: "Step by step", how: "each step of a cycle, played by itself" },
    advice: { what: "Cutting data and advice", how: "starting values for material, tool and insert" },
    which: { what: "Find a cycle", how: "give the shape: every way is simulated and compared" },
    code: { what: "Tools from ISO codes", how: "one line such as CNMG 120408 fills in the tool" },
    contour: { what: "Contours with unknowns", how: "missing dimensions are calculated from the others" },
    approach: { what: "APPR and DEP", how: "all eight functions, on your own contour" },
    compare: { what: "Compare programs", how: "by what they do, with the time that a change costs" },
    drawing: { what: "Workshop drawing", how: "of any program, with dimensions, to print" },
    share: { what: "Share by QR code", how: "program, tools and check result in one link" },
    verify: { what: "Check on the command line", how: "node verify.mjs PROGRAM.H, without a browser" },
  },
};

export type StartTexts = Shape<typeof start>;
