import type { Shape } from "../shape.ts";

export const setup = {
  notes: "Before this cycle runs",
  tool: {
    title: "Tool",
    list: "Turning tools",
    name: (number: number, name: string) => `Tool ${number} ${name}`,
    types: {
      ROUGH: "roughing",
      FINISH: "finishing",
      RECESS: "recessing",
      RECTURN: "recess turning",
      BUTTON: "button",
      THREAD: "threading",
    },
    radius: (value: string) => `nose ${value}`,
    width: (value: string) => `width ${value}`,
    angles: (setting: string, point: string) => `${setting}° / ${point}°`,
    cutLength: (value: string) => `cutting length ${value}`,
    orientation: (value: number) => `orientation ${value}`,
    makes: "makes the contour",
    leaves: (length: string) => `leaves ${length} mm of the contour`,
    cannot: "cannot make the contour",
    better: (number: number, name: string) => `Tool ${number} ${name} makes this contour.`,
    noneMakes: "No tool of the table makes the whole contour.",
    take: (number: number) => `Take tool ${number}`,
    choose: "Choose another tool",
    edit: "Edit this tool",
    drawing: "Insert to scale",
  },
  parameters: {
    title: "Q parameters used",
    hint: "They stand in prompts. The program sets them before the cycle.",
    ask: (name: string) => `Which value has ${name}?`,
  },
  blank: {
    title: "Blank: cylinder",
    outside: "Outside ⌀",
    bore: "Bore ⌀ (0: solid)",
    length: "Length",
    allowance: "In front of Z0",
  },
  start: {
    title: "Cycle start point",
    x: "Start X",
    z: "Start Z",
    hint: "Where the tool tip stands at the cycle call. The cycle cuts from here.",
  },
  spindle: {
    title: "Spindle",
    mode: "Speed",
    constant: "Constant speed",
    surface: "Constant cutting speed",
    speed: "Speed S",
    cuttingSpeed: "Cutting speed VC",
    limit: "Speed limit SMAX",
  },
  feed: {
    title: "Feed and rapid",
    perRevolution: "M136: feeds in mm per revolution",
    rapid: "Rapid rate (for the time only)",
  },
  units: { diameter: "mm ⌀", mm: "mm", rpm: "rpm", cuttingSpeed: "m/min", perMinute: "mm/min" },
  wrong: {
    missing: "Enter a value.",
    notANumber: "This is not a number.",
    negative: "The value must be 0 or more.",
    positive: "The value must be more than 0.",
  },
};

export type SetupTexts = Shape<typeof setup>;
