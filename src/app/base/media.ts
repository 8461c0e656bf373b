const LYING = "(599px < width <= 1279px) and (orientation: landscape)";
const VAST = "(min-width: 2200px)";

/**
 * Where the layout changes, once: style sheets write `@media (--phone)` and so on, which the build replaces
 * (vite.config.ts), and components ask for the same by name.
 */
export const MEDIA = {
  /** One thing at a time. */
  phone: "(max-width: 599px)",
  /** Pages of lists and forms have one column. */
  slim: "(max-width: 819px)",
  /** The picture over the prompts: a tablet held upright. */
  portrait: "(599px < width <= 1279px) and (orientation: portrait)",
  /** The picture beside the prompts: a tablet that lies, or a small window. */
  landscape: LYING,
  /** A phone that lies: the height of a few rows. */
  flat: `${LYING} and (max-height: 499px)`,
  /** No room for three columns. */
  narrow: "(max-width: 1279px)",
  /** Three columns: the program or the text stands beside the view. */
  wide: "(min-width: 1280px)",
  /** The columns beside the view become wider. */
  roomy: "(min-width: 1440px)",
  /** The view becomes wider too. */
  broad: "(min-width: 1760px)",
  /** A second pane beside the view: large screens and projectors of their size. */
  vast: VAST,
  /** The help picture lies in the pane of the view, not among the prompts. */
  docked: `(${LYING} and (min-height: 500px)) or ${VAST}`,
  /** A notebook: little height. */
  low: "(max-height: 899px)",
  /** The main pointer is a finger. */
  coarse: "(pointer: coarse)",
  /** Fingers work here: the page shows its own keypad and large targets. */
  fingers: "(pointer: coarse), (max-width: 1279px)",
} as const;
