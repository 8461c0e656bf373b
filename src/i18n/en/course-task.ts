import type { Shape } from "../shape.ts";

/**
 * A task of the course while it is worked on: its panel, its goals, and what became of them. Numbers come written in
 * the language.
 */
export const courseTask = {
  region: (title: string) => `Task: ${title}`,
  unfold: "Assignment",
  fold: "To the work",
  goals: "Goals",
  met: "met",
  notMet: "not met",
  check: "Check",
  checking: "Being checked",
  passed: "Passed",
  passedFor: {
    alone: "Passed, without help",
    hints: "Passed, with hints",
    solution: "Passed, after the solution was shown",
  },
  failed: (open: number, all: number) =>
    open === 1 ? `1 of ${all} goals is not met yet` : `${open} of ${all} goals are not met yet`,
  stale: "Changed since the last check",
  tries: (n: number) => (n === 1 ? "1 try" : `${n} tries`),
  empty: (names: string) => `That is no try yet. Still empty: ${names}`,
  noContour: "The contour is still empty. That is no try.",
  noRun: "Nothing in the program cuts yet. That is no try.",
  notRun: "The program was not calculated. Check once more.",
  goTo: (name: string) => `Go to ${name}`,
  previous: "Previous place",
  next: "Next place",
  count: (n: number, of: number) => `${n} of ${of}`,
  hint: (n: number) => `Hint ${n} of 3`,
  showHint: (n: number) => `Show hint ${n} of 3`,
  solution: "Solution",
  showSolution: "Show the solution",
  sure: "It is shown beside your own work, which stays as it is. The task then counts as passed after the solution.",
  yesShow: "Show it",
  notYet: "Not yet",
  compare: "Compare with mine",
  openSolution: "Open as a work of its own",
  solutionName: "Solution",
  learned: "What was learned",
  nextTask: (title: string) => `Next task: ${title}`,
  toLesson: "To the lesson",
  toCourse: "To the course",
  anew: "Begin anew",
  gone: "The file of this task is not here. The work is as it was.",

  is: {
    part: "The wanted part, nothing missing and nothing left over",
    partLeaving: (area: string) => `The wanted part; at most ${area} may stay on it`,
    size: {
      diameter: (size: string, z: string) => `⌀ ${size} at Z ${z}`,
      bore: (size: string, z: string) => `Bore ⌀ ${size} at Z ${z}`,
      face: (size: string, x: string) => `Shoulder at Z ${size}, at ⌀ ${x}`,
    },
    drawn: (n: number) => (n === 1 ? "One size as drawn" : `${n} sizes as drawn`),
    drawnWrong: (n: number, wrong: number) => `${n} sizes as drawn: ${wrong} not yet`,
    safe: "No error, no rapid through steel, no holder against it",
    clean: "No warning either",
    depth: (mm: string) => `At most ${mm} mm a pass`,
    speed: (rpm: string) => `At most ${rpm} rpm`,
    tools: (list: string) => `No tool but ${list}`,
    and: (all: string, last: string) => `${all} and ${last}`,
    mostTools: (n: number) => (n === 1 ? "One tool" : `At most ${n} tools`),
    seconds: (s: string) => `At most ${s} s`,
    cycles: (cycle: string) => `With cycle ${cycle}`,
    without: (cycle: string) => `Without cycle ${cycle}`,
    passes: (n: number) => (n === 1 ? "Exactly one roughing pass" : `Exactly ${n} roughing passes`),
    rz: (most: string, from: string, to: string) => `Rz at most ${most} µm from Z ${from} to Z ${to}`,
    words: (word: string) => `${word} in the program`,
    exact: (q: string, value: string) => `${q} = ${value}`,
    between: (q: string, from: string, to: string) => `${q} from ${from} to ${to}`,
    least: (q: string, from: string) => `${q} at least ${from}`,
    most: (q: string, to: string) => `${q} at most ${to}`,
    ofCycle: (what: string, cycle: string) => `${what} in cycle ${cycle}`,
    foretold: (n: number, of: number) => (of === 1 ? "Foretold rightly" : `Question ${n} foretold rightly`),
  },

  wrong: {
    unproved: (what: string) => `${what} is not simulated: what follows cannot be judged`,
    unprovedMilling: "Milling is not judged",
    blank: "The blank is not that of the task",
    rapid: "A rapid runs into steel",
    holder: "The holder touches the steel",
    gouge: "The contour is cut into",
    missing: (mm: string) => `${mm} mm too much was cut`,
    residue: (mm: string) => `Steel stays, up to ${mm} mm thick`,
    noThread: (name: string) => `The thread ${name} is not there: no groove is cut between its crest and its root`,
    threadPitch: (name: string, is: string, asked: string) =>
      `The thread ${name} has a pitch of ${is} mm in place of ${asked}`,
    turnedRound: {
      inside:
        "As the values stand, this cycle turns a bore: " +
        "its contour lies above the start point. Look at the diameters and at the start before the tool",
      outside:
        "As the values stand, this cycle turns the outside: " +
        "its contour lies below the start point. Look at the diameters and at the start before the tool",
      away:
        "As the values stand, this cycle cuts away from the chuck: " +
        "its end lies in front of its start. Look for a forgotten minus before the tool",
      towards:
        "As the values stand, this cycle cuts towards the chuck: its end lies behind its start. Look at the signs along Z before the tool",
    },
    thread: (name: string) => `The thread ${name} is not cut all along, to its depth and at its pitch`,
    leftBy: (what: string, reason: string) => `${what}, left by ${reason}`,
    size: {
      diameter: (is: string, asked: string) => `⌀ ${is} in place of ⌀ ${asked}`,
      bore: (is: string, asked: string) => `Bore ⌀ ${is} in place of ⌀ ${asked}`,
      face: (is: string, asked: string) => `The shoulder stands at Z ${is} in place of ${asked}`,
    },
    noSize: (asked: string) => `There is nothing to measure for ${asked}`,
    depth: (is: string, most: string) => `A pass takes ${is} mm; ${most} mm are allowed`,
    speed: (is: string, most: string) => `The spindle may turn at ${is} rpm; ${most} rpm are allowed`,
    noLimit: (most: string) => `Nothing limits the spindle to ${most} rpm`,
    tools: (tool: string) => `Tool ${tool} is not among those of the task`,
    mostTools: (is: string, most: string) => `${is} tools are called; ${most} would do`,
    seconds: (is: string, most: string) => `It takes ${is} s; ${most} s are allowed`,
    cycles: (cycle: string) => `Cycle ${cycle} is not called, or cuts nothing`,
    without: (cycle: string) => `Cycle ${cycle} is called`,
    values: (q: string, is: string, asked: string) => `${q} is ${is}. Asked for: ${asked}`,
    noValue: (q: string) => `No cycle with ${q} is called`,
    passes: (is: number, asked: number) =>
      `${is === 1 ? "1 roughing pass" : `${is} roughing passes`} in place of ${asked}`,
    rz: (is: string, most: string) => `Rz ${is} µm in place of ${most} µm`,
    noRz: (most: string) => `No surface with a known Rz; ${most} µm are asked for`,
    words: (word: string) => `${word} stands in no block`,
  },
  where: {
    place: (x: string, z: string) => `⌀${x}, Z${z}`,
    at: (what: string, x: string, z: string) => `${what} at ⌀${x}, Z${z}`,
    because: (what: string, cause: string) => `${what}: ${cause}`,
    block: (block: string) => `block ${block}`,
    pass: (block: string, pass: string) => `block ${block}, pass ${pass}`,
    finish: (block: string) => `block ${block}, finishing cut`,
  },

  foretell: {
    title: "First, say what will happen",
    lead: "The run is shown when you have answered.",
    question: (n: number, of: number) => `Question ${n} of ${of}`,
    units: { passes: "passes", infeed: "mm", seconds: "s", residue: "mm²", diameter: "mm", bore: "mm", face: "mm" },
    answer: "Your answer",
    place: "Tap the place on the part, or type it:",
    x: "⌀ of the place",
    z: "Z of the place",
    block: "Number of the block",
    tapBlock: "Type its number, or choose the line in the program.",
    toPointed: { place: "Tap it on the part", block: "Choose it in the program" },
    nextQuestion: "Next question",
    back: "Question before",
    run: "Show the run",
    lacks: (n: number, of: number) =>
      of === 1 ? "Your answer is still missing." : `Question ${n} still lacks its answer.`,
    again: "Say it again",
    right: (what: string) => `Right: ${what}`,
    wrong: (told: string, is: string) => `You said ${told}. It is ${is}.`,
    wrongBlock: (told: string) => `Block ${told} is not the cause. Watch where it goes wrong, and say it again.`,
    wrongPlace: (told: string, is: string, mm: string) => `You said ${told}. It is at ${is}, ${mm} mm away.`,
    nowhere: (told: string) => `You said ${told}. It happens nowhere.`,
    yours: "Your answer in the picture",
    truth: "Where it is",
    isBlock: (block: string) => `block ${block}`,
  },

  score: {
    title: "Score",
    of: (points: string) => `${points} of 100 points`,
    parts: { proof: "Rules held", residue: "Residue", time: "Time", tools: "Tools" },
    better: {
      proof: (is: string, of: string) => `${is} of ${of} rules hold; each one gives its share.`,
      residue: (is: string) => `${is} stay on the part; less gives more.`,
      time: (is: string, par: string) =>
        `${is} s; ${par} s give full points: fewer passes, shorter ways, or more feed.`,
      tools: (is: string, par: string) => `${is} tools; ${par} give full points.`,
    },
  },
  drawing: "Drawing",
};

export type CourseTaskTexts = Shape<typeof courseTask>;
