import type { Shape } from "../../shape.ts";

export const page = {
  product: "Turnwise",
  home: "Turnwise, start page",
  promise: "Program HEIDENHAIN turning cycles: see every cut, check it, export the program.",
  skipToPrompts: "Skip to the prompts",
  header: "Program and settings",
  keys: "Keyboard shortcuts",
  commands: "Commands",
  undo: "Undo",
  redo: "Redo",
  newProgram: "New program",
  settings: "Settings",
  close: "Close",
  screenLanguage: "Screen language",
  control: "Control (APPR and DEP with Z)",
  controls: { "TNC 640": "TNC 640: in the plane first, then in Z", TNC7: "TNC7: in all axes at once" },
  theme: "Appearance",
  themes: { system: "System", light: "Light", dark: "Dark" },
  motion: "Motion",
  size: "Type size",
  sizes: { usual: "Default", presentation: "Presentation" },
  motions: { system: "System", reduced: "None" },
  gallery: "Cycle gallery",
  disclaimer:
    "Based on printed cycle manuals; not a HEIDENHAIN product. Verify every program on your control before machining.",

  sections: "Parts of the program",
  prompts: "Prompts",
  setup: "Set-up",
  contour: "Contour",
  program: "Program",
  lathe: "Lathe",
  timeline: "Timeline",

  columns: {
    left: "Width of the left column",
    right: "Width of the program text",
    hint: "Drag, or use the arrow keys. Double-click or Enter: default width",
  },

  start: {
    which: "Find a cycle",
    title: "Program HEIDENHAIN turning cycles for TNC 640 and TNC7 and see every cut",
    choose: "Choose a cycle",
    chooseLead: "Select a cycle to start with example values, or “Blank” for no values.",
    search: "Search cycles, examples and your programs",
    found: (n: number) => (n === 1 ? "1 found." : `${n} found.`),
    foundWork: (name: string) => `Saved program: ${name}`,
    foundExample: (title: string) => `Example: ${title}`,
    withExample: "Start with example values",
    empty: "Start blank",
    cycle: (number: number, name: string) => `Cycle ${number}, ${name}`,
    kept: "Saved on this device",
    allWorks: (n: number) => `All programs (${n})`,
    isElsewhere: "open in another tab",
    task: "Exercise",
    program: "NC program",
    exercises: (count: number) => `Exercises (${count})`,
    continueWork: (name: string) => `Continue ${name}`,
    forget: (name: string) => `Remove ${name} from the list`,
    removed: (name: string) => `${name} was removed.`,
    changed: (when: string) => `changed ${when}`,
  },

  programs: {
    title: "NC programs",
    openFile: "Open a program",
    openFolder: "Open folder",
    paste: "Paste a program",
    create: "New program",
    drop: "or drop files or paste text here",
    dropHere: "Drop the program here, with the files it calls",
    examples: "Examples",
    example: (title: string) => `Open the example ${title}`,
    fromJob: "Convert to NC program",
    fromJobLong: "Convert to an NC program; the cycle with its prompts is kept as a separate program",
    pasteTitle: "Paste a program",
    pasteLabel: "Program text",
    pasteOpen: "Open",
    cancel: "Cancel",
    unreadable: "This file could not be read.",
    tooLarge: "Larger than 20 MB.",
  },
  examples: {
    flange: "Flange: six tools, eight cycles",
    shaft: "Shaft: ten operations, ten tools; taper, undercut, recesses, external and internal threads",
    shoulder: "Manual example 812 (French)",
    contour: "Manual example 820 (French)",
    contourEnglish: "Manual example 820 (English)",
    groove: "Manual example 852 (French)",
    plate: "Milled plate: approach and departure",
  },
  loading: "Loading the editor …",
  readingDevice: "Reading the programs of this device …",
  tools: {
    title: "Tool table",
    open: "Tools",
    openLong: "Open the tool table",
  },
  own: { title: "Own cycles" },
  works: { title: "All programs" },

  effect: {
    title: "Effect of these values",
    passes: "Passes",
    infeed: "Infeed",
    infeedUnit: "mm per pass",
    time: "Time",
    chip: "Chip area",
    residual: "Residual",
    none: "none",
    unknown: "–",
    waiting: "No tool path with these values; the last valid simulation is shown.",
    duration: (minutes: number, seconds: string) =>
      minutes < 60
        ? minutes > 0
          ? `${minutes} min ${seconds} s`
          : `${seconds} s`
        : `${Math.floor(minutes / 60)} h ${minutes % 60} min`,
    faults: "Contour damage and collisions",
    pin: {
      make: "Pin as reference",
      title: "Pinned reference",
      pinned: "Reference",
      now: "Now",
      back: "Restore",
      letGo: "Unpin",
      fold: "Hide comparison",
      unfold: "Show comparison",
    },
  },

  text: {
    title: "Program text",
    name: "Program name",
    layout: "Layout",
    layouts: { tnc640: "TNC 640", tnc7: "TNC7", iso: "DIN/ISO", manual: "As in the manual" },
    files: { tnc640: "Klartext file for TNC 640", tnc7: "Klartext file for TNC7", iso: "DIN/ISO file" },
    manualView:
      "Shown as printed in the manual, without ~. A control cannot load this form; Copy and Download use the file format.",
    showFile: "Show the file",
    untied: "Cycle lists without ~: a control cannot load this program.",
    tie: "Add ~",
    isoKept: (blocks: string) => `No DIN/ISO equivalent, kept in Klartext: ${blocks}.`,
    isoUnverified: "Word order within a block is unverified; compare on your control.",
    output: "NC output",
    asIso: "DIN/ISO file",
    language: "Labels",
    languageLong: "Language of the program text",
    noChinese: "No known manual prints Chinese labels; the Chinese TNC7 manual uses English ones.",
    copy: "Copy",
    copyLong: "Copy the program",
    copied: "Copied",
    copiedLong: (blocks: number) => `The program is on the clipboard: ${blocks} blocks.`,
    download: (file: string) => `Download ${file}`,
    fold: "Hide program",
    unfold: "Show program",
    exportMenu: "Export",
    setupSheet: "Setup sheet",
    clamping: "Material, clamping",
    workshopDrawing: "Workshop drawing",
    handOn: "Share",
    exportPart: "Export part",
    turnRound: "Flip part",
    makeTask: "Create exercise",
    compare: "Compare",
    blocks: "Blocks of the program",
    running: "running",
    refusedTitle: "Copy by hand",
    refused:
      "The browser does not allow access to the clipboard. The text below is selected: press Ctrl+C, or hold and choose Copy.",
    incomplete: "Program incomplete",
  },

  notice: {
    dismiss: "Dismiss",
    damaged: (n: number) =>
      n === 1
        ? "One saved program could not be read. It was set aside, nothing was deleted."
        : `${n} saved programs could not be read. They were set aside, nothing was deleted.`,
    notKept:
      "This browser does not save programs on the device. Copy or download the program before you close the page.",
    storageFull:
      "The device storage is full: the latest changes are not saved. Download the program, or remove programs on the start page.",
    storageSilent:
      "The browser’s storage does not answer. You can go on working, but changes exist only in this page until it answers: download the program before you close the page.",
    newerData:
      "Some data on this device were saved by a newer version of this page. They are left as they are, and changes to them are not saved. Reload the page to get that version.",
    rowsAside:
      "Some entries of your tables could not be read. They were set aside: see the page of all programs. Nothing was deleted.",
    rowUnreadable: (name: string) => `${name} cannot be shown.`,
    newerWorks:
      "Some saved programs come from a newer version of this page. They are listed below all programs; nothing was deleted.",
    downloadUnkept: "Download the program",
    archiveUnkept: "Back up as one file",
    copyOfOtherTab: "This program is open in another tab. You are editing a copy; both are kept.",
    workNotHere:
      "The program at this address is not on this device: it is in another browser, or was removed from the list.",
    linkDamaged: "The link contains no readable data.",
    linkNewer: "The link comes from a newer version of this page. Reload the page and open the link again.",
    linkTooLarge: "The program in the link is larger than 20 MB and was not opened. Your own program is unchanged.",
    fileTooLarge: "The file is larger than 20 MB and was not opened. Your own program is unchanged.",
    fileUnreadable: "The file could not be read and was not opened. Your own program is unchanged.",
    engineFailed:
      "The calculation stopped unexpectedly. Your values are kept, and you can start the calculation again.",
    toolsDamaged: "The saved tool table could not be read. It was set aside; the default tools are used.",
    filesLeftOut:
      "Not all files of the folder were opened: files that are not program texts, or exceed the limit, were left out.",
    isoRead: "The DIN/ISO program was converted to Klartext for editing. “DIN/ISO file” converts the program back.",
    mainUnsure:
      "No program here calls all the others. To run a different one, choose it in the list of files above the text.",
    toolsNotKept:
      "This browser does not save the tool table on the device. Export the table before you close the page.",
    ownDamaged: "The saved own cycles could not be read. They were set aside, nothing was deleted.",
    ownNotKept: "This browser does not save own cycles on the device. Export them before you close the page.",
    crashTitle: "An error occurred on this page",
    crash: "Your program is saved on this device.",
    missing: {
      offline:
        "This part of the page could not be loaded: no network. Open programs are kept; the part loads when the network is back.",
      gone: "This part of the page could not be loaded from the server. Open programs are kept, even if you reload the page.",
    },
    tryAgain: "Try again",
    reload: "Reload the page",
    startOver: "Go to the start page",
  },
};

export type PageTexts = Shape<typeof page>;
