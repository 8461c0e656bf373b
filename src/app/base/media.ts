const LYING = "(599px < width <= 1279px) and ((orientation: landscape) or (max-height: 699px))";
const FLAT = `${LYING} and (max-height: 499px)`;

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
  portrait: "(599px < width <= 1279px) and (orientation: portrait) and (min-height: 700px)",
  /** The picture beside the prompts: a tablet in landscape, or a small window. */
  landscape: LYING,
  /**
   * Little height beside or below the picture: field, value and keypad are pinned, and what is between them scrolls
   * (styles/short.css).
   */
  short: "(max-width: 1279px) and (max-height: 699px)",
  /** A phone in landscape: the height of a few rows. */
  flat: FLAT,
  /** The header has room for the name of the open work and few buttons: the others are in its menu. */
  folded: `(max-width: 599px), ${FLAT}`,
  /** A short phone: the picture is a strip above the prompts until it is enlarged. */
  strip: "(max-width: 599px) and (max-height: 699px)",
  /** A short phone with room for two lines of numbers below the strip. */
  stacked: "(max-width: 479px) and (min-height: 600px) and (max-height: 699px)",
  /** A small window at 400 % zoom: the whole page scrolls, with its header. */
  tiny: "(max-width: 599px) and (max-height: 479px)",
  /** No room for three columns. */
  narrow: "(max-width: 1279px)",
  /** Three columns: the program text is beside the view. */
  wide: "(min-width: 1280px)",
  /** The columns beside the view become wider. */
  roomy: "(min-width: 1440px)",
  /** The view becomes wider too. */
  broad: "(min-width: 1760px)",
  /** A second pane beside the view: large screens and projectors of their size. */
  vast: "(min-width: 2200px)",
  /** The help picture is in the pane of the view, not among the prompts. */
  docked: `${LYING} and (min-height: 500px)`,
  /** A notebook: little height. */
  low: "(max-height: 899px)",
  /** The main pointer is a finger. */
  coarse: "(pointer: coarse)",
  /** Fingers work here: the page shows its own keypad and large targets. */
  fingers: "(pointer: coarse), (max-width: 1279px)",
} as const;
