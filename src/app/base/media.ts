const LYING = "(599px < width <= 1279px) and (orientation: landscape)";
const VAST = "(min-width: 2200px)";

/**
 * The breakpoints of the layout: style sheets write `@media (--phone)` and so on, which the build replaces
 * (vite.config.ts), and components use the same names.
 */
export const MEDIA = {
  /** One panel at a time. */
  phone: "(max-width: 599px)",
  /** Pages of lists and forms have one column. */
  slim: "(max-width: 819px)",
  /** The picture above the prompts: an upright tablet. */
  portrait: "(599px < width <= 1279px) and (orientation: portrait)",
  /** The picture beside the prompts: a tablet in landscape, or a small window. */
  landscape: LYING,
  /** A phone in landscape: the height of a few rows. */
  flat: `${LYING} and (max-height: 499px)`,
  /** No room for three columns. */
  narrow: "(max-width: 1279px)",
  /** Three columns: the program text is beside the view. */
  wide: "(min-width: 1280px)",
  /** The columns beside the view become wider. */
  roomy: "(min-width: 1440px)",
  /** The view becomes wider too. */
  broad: "(min-width: 1760px)",
  /** A second pane beside the view: large screens and projectors of their size. */
  vast: VAST,
  /** The help picture is in the pane of the view, not among the prompts. */
  docked: `(${LYING} and (min-height: 500px)) or ${VAST}`,
  /** A notebook: little height. */
  low: "(max-height: 899px)",
  /** The main pointer is a finger. */
  coarse: "(pointer: coarse)",
  /** Fingers work here: the page shows its own keypad and large targets. */
  fingers: "(pointer: coarse), (max-width: 1279px)",
} as const;
