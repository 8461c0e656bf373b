import type { Shape } from "../shape.ts";

/**
 * An exercise of the course while it is open: its panel, its goals, and the result of a check. Numbers arrive as text of
 * the language.
 */
export const courseTask = {
  region: (title: string) => `Exercise: ${title}`,
  unfold: "Assignment",
  fold: "Back to the editor",
  goals: "Goals",
  met: "met",
  notMet: "not met",
  check: "Check",
  checking: "Checking …",
  passed: "Passed",
  passedFor: {
    alone: "Passed unaided",
    hints: "Passed with hints",
    solution: "Passed after the solution was shown",
  },
  failed: (open: number, all: number) =>
    open === 1 ? `1 of ${all} goals is not met yet` : `${open} of ${all} goals are not met yet`,
  stale: "Changed since the last check",
  tries: (n: number) => (n === 1 ? "1 try" : `${n} tries`),
  empty: (names: string) => `Not counted yet. Still empty: ${names}`,
  noContour: "The contour is still empty; this does not count as a try.",
  noRun: "Nothing is cut yet; this does not count as a try.",
  notRun: "The program was not calculated. Check again.",
  goTo: (name: string) => `Go to ${name}`,
  previous: "Previous place",
  next: "Next place",
  count: (n: number, of: number) => `${n} of ${of}`,
  hint: (n: number, of: number) => `Hint ${n} of ${of}`,
  showHint: (n: number, of: number) => `Show hint ${n} of ${of}`,
  lastCheck: "Goals not met at the last check",
  against: "against its own contour, not the part of the exercise",
  heldBack: "Fixes are offered after a hint or three tries.",
  lessonTask: (lesson: number, n: number, of: number) => `Lesson ${lesson} · ${n} of ${of}`,
  showPlace: "Show the place",
  hintAfterTry: "The last hint is available after the first counted try.",
  solution: "Solution",
  showSolution: "Show the solution",
  confirmSolution:
    "The solution is shown next to your program, which is not changed. The exercise then counts as passed with the solution shown.",
  confirmShow: "Show it",
  cancelShow: "Not yet",
  compare: "Compare with mine",
  openSolution: "Open as a new program",
  solutionName: "Solution",
  learned: "What you learned",
  nextTask: (title: string) => `Next exercise: ${title}`,
  toLesson: "To the lesson",
  toCourse: "To the course",
  startOver: "Start over",
  fileMissing: "The file of this exercise is missing. Your program is unchanged.",

  is: {
    part: "The part as drawn, with no excess and nothing missing",
    partLeaving: (area: string) => `The part as drawn; at most ${area} of excess`,
    size: {
      diameter: (size: string, z: string) => `⌀ ${size} at Z ${z}`,
      bore: (size: string, z: string) => `Bore ⌀ ${size} at Z ${z}`,
      face: (size: string, x: string) => `Shoulder at Z ${size}, at ⌀ ${x}`,
    },
    drawn: (n: number) => (n === 1 ? "One size as drawn" : `${n} sizes as drawn`),
    drawnWrong: (n: number, wrong: number) => `${n} sizes as drawn: ${wrong} not yet`,
    safe: "No errors, no rapids through material, holder clear",
    clean: "No warnings",
    depth: (mm: string) => `At most ${mm} mm per pass`,
    speed: (rpm: string) => `At most ${rpm} rpm`,
    tools: (list: string, n: number) => (n === 1 ? `Only tool ${list}` : `Only tools ${list}`),
    and: (all: string, last: string) => `${all} and ${last}`,
    mostTools: (n: number) => (n === 1 ? "One tool" : `At most ${n} tools`),
    seconds: (s: string) => `At most ${s}`,
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
    answered: (n: number, of: number) => (of === 1 ? "Answered correctly" : `Question ${n} answered correctly`),
  },

  wrong: {
    unproved: (what: string) => `${what} is not simulated: the moves after it cannot be checked`,
    unprovedMilling: "Milling is not checked",
    blank: "The blank differs from that of the exercise",
    rapid: "Rapid traverse into material",
    holder: "The holder touches material",
    gouge: "Contour damage",
    missing: (mm: string) => `Cut ${mm} mm into the part`,
    residue: (mm: string) => `Material left, up to ${mm} mm thick`,
    noThread: (name: string) => `Thread ${name} is missing: no groove is cut between crest and root`,
    threadPitch: (name: string, is: string, asked: string) =>
      `Thread ${name} has a pitch of ${is} mm instead of ${asked}`,
    wrongSide: {
      inside:
        "With these values the cycle turns a bore: " +
        "its contour is above the start point. Check the diameters and the start first, then the tool",
      outside:
        "With these values the cycle turns the outside: " +
        "its contour is below the start point. Check the diameters and the start first, then the tool",
      away:
        "With these values the cycle cuts away from the chuck: " +
        "its end is in front of its start. Look for a forgotten minus first, then check the tool",
      towards:
        "With these values the cycle cuts towards the chuck: its end is behind its start. Check the signs along Z first, then the tool",
    },
    thread: (name: string) => `Thread ${name} is not cut over its full length, to its depth and at its pitch`,
    leftBy: (what: string, reason: string) => `${what}, cause: ${reason}`,
    size: {
      diameter: (is: string, asked: string) => `⌀ ${is} instead of ⌀ ${asked}`,
      bore: (is: string, asked: string) => `Bore ⌀ ${is} instead of ⌀ ${asked}`,
      face: (is: string, asked: string) => `The shoulder is at Z ${is} instead of ${asked}`,
    },
    half: (said: string) => `${said}, exactly half of it: a radius?`,
    twice: (said: string) => `${said}, exactly twice as much: a diameter entered as a radius?`,
    noSize: (asked: string) => `No material to measure for ${asked}`,
    depth: (is: string, most: string) => `A pass is ${is} mm deep; ${most} mm are allowed`,
    speed: (is: string, most: string) => `The spindle can reach ${is} rpm; ${most} rpm are allowed`,
    noLimit: (most: string) => `The spindle speed is not limited to ${most} rpm`,
    tools: (tool: string) => `Tool ${tool} is not allowed in this exercise`,
    mostTools: (is: string, most: string) => `${is} tools are called; ${most} are enough`,
    seconds: (is: string, most: string) => `It takes ${is}; ${most} are allowed`,
    cycles: (cycle: string) => `Cycle ${cycle} is not called, or cuts nothing`,
    without: (cycle: string) => `Cycle ${cycle} is called`,
    values: (q: string, is: string, asked: string) => `${q} is ${is}. Required: ${asked}`,
    noValue: (q: string) => `No cycle with ${q} is called`,
    passes: (is: number, asked: number) =>
      `${is === 1 ? "1 roughing pass" : `${is} roughing passes`} instead of ${asked}`,
    rz: (is: string, most: string) => `Rz ${is} µm instead of ${most} µm`,
    noRz: (most: string) => `No surface with a known Rz; ${most} µm are required`,
    words: (word: string) => `${word} is in no block`,
  },
  slip: {
    sign: (name: string, is: string, better: string) => `Wrong sign? ${name} is ${is}, not ${better}`,
    radius: (name: string, is: string, better: string) =>
      `Radius entered as a diameter? ${name} is ${is}, half of ${better}`,
    doubled: (name: string, is: string, better: string) => `Diameter doubled? ${name} is ${is}, twice ${better}`,
    exchanged: (one: string, other: string) => `Exchanged? ${one} and ${other}`,
    reversed: "Contour in the wrong direction? It begins at the wrong end",
    where: (what: string, block: string) => `${what} (${block})`,
  },
  where: {
    shapedBy: (what: string) => `shaped by ${what}`,
    place: (x: string, z: string) => `⌀${x}, Z${z}`,
    at: (what: string, x: string, z: string) => `${what} at ⌀${x}, Z${z}`,
    because: (what: string, cause: string) => `${what}: ${cause}`,
    block: (block: string) => `block ${block}`,
    pass: (block: string, pass: string) => `block ${block}, pass ${pass}`,
    finish: (block: string) => `block ${block}, finishing cut`,
  },

  predict: {
    title: "Predict what will happen",
    lead: "The run is shown after you answer.",
    question: (n: number, of: number) => `Question ${n} of ${of}`,
    units: { passes: "passes", infeed: "mm", seconds: "s", residue: "mm²", diameter: "mm", bore: "mm", face: "mm" },
    answer: "Your answer",
    place: "Tap the place on the part, or type it:",
    x: "⌀ of the place",
    z: "Z of the place",
    block: "Number of the block",
    tapBlock: "Type its number, or choose the line in the program.",
    pointAt: { place: "Tap it on the part", block: "Choose it in the program" },
    nextQuestion: "Next question",
    back: "Previous question",
    run: "Show the run",
    lacks: (n: number, of: number) =>
      of === 1 ? "Your answer is still missing." : `The answer to question ${n} is still missing.`,
    wrongAgain: (told: string) => `Your answer: ${told}. Not correct. Watch the run, then try again.`,
    decides: (block: string) => `Block ${block} decides.`,
    kept: "Answered correctly before",
    otherNumbers: (places: readonly string[]) =>
      `New numbers in ${places.join(", ")}. Read the program again; the hints keep the original numbers.`,
    sameNumbers:
      "The answer was shown and there are no other numbers: this now counts as passed after the solution was shown.",
    again: "Try again",
    right: (what: string) => `Correct: ${what}`,
    wrong: (told: string, is: string) => `Your answer: ${told}. Correct: ${is}.`,
    wrongBlock: (told: string) => `Block ${told} is not the cause. Watch where the fault occurs, then try again.`,
    wrongPlace: (told: string, is: string, mm: string) => `Your answer: ${told}. Correct: ${is}, ${mm} mm away.`,
    doesNotOccur: (told: string) => `Your answer: ${told}. This does not occur anywhere.`,
    yours: "Your answer in the picture",
    truth: "Correct place",
    isBlock: (block: string) => `block ${block}`,
  },

  score: {
    title: "Score",
    of: (points: string) => `${points} of 100 points`,
    parts: { proof: "Rules met", residue: "Residual material", time: "Time", tools: "Tools" },
    better: {
      proof: (is: string, of: string) => `${is} of ${of} rules are met; each counts equally.`,
      residue: (is: string) => `${is} residual material; less gives more points.`,
      time: (is: string, par: string) =>
        `${is}; ${par} give full points: use fewer passes, shorter paths or a higher feed.`,
      tools: (is: string, par: string) => `${is} tools; ${par} give full points.`,
    },
  },
  drawing: "Drawing",
};

export type CourseTaskTexts = Shape<typeof courseTask>;
