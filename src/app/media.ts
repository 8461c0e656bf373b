/**
 * Where the layout changes, once: style sheets write `@media (--phone)` and so on, which the build replaces (vite.config.ts), and
 * components ask for the same by name.
 */
export const MEDIA = {
  /** One thing at a time. */
  phone: "(max-width: 819px)",
  /** Two columns: a tablet. */
  tablet: "(819px < width <= 1279px)",
  /** No room for three columns. */
  narrow: "(max-width: 1279px)",
  /** Three columns: the program or the text stands beside the view. */
  wide: "(min-width: 1280px)",
  /** The columns beside the view become wider. */
  roomy: "(min-width: 1440px)",
  /** The view becomes wider too. */
  broad: "(min-width: 1760px)",
  /** A notebook: little height. */
  low: "(max-height: 899px)",
  /** Fingers work here: the page shows its own keypad and large targets. */
  fingers: "(pointer: coarse), (max-width: 1279px)",
} as const;
