import { Glyph, type GlyphName } from "./Glyph.tsx";

/** A button with a glyph and an accessible name, and with text where there is room. */
export function GlyphButton({
  glyph,
  name,
  onPress,
  pressed,
  expanded,
  disabled,
  text,
  isEarly = false,
  hint,
}: {
  readonly glyph: GlyphName;
  readonly name: string;
  readonly onPress: () => void;
  /** For switches: on or off. */
  readonly pressed?: boolean;
  /** For a button that expands something. */
  readonly expanded?: boolean;
  /** It keeps the focus where a press has ended what it does. */
  readonly disabled?: boolean;
  /** Visible text: its name, or a shorter one. */
  readonly text?: string;
  /** Its text comes before that of others as the bar gets wider. */
  readonly isEarly?: boolean;
  /** Tooltip. */
  readonly hint?: string;
}) {
  return (
    <button
      type="button"
      className="button icon"
      aria-label={name}
      title={hint ?? name}
      aria-pressed={pressed}
      aria-expanded={expanded}
      aria-disabled={disabled}
      onClick={() => !disabled && onPress()}
    >
      <Glyph name={glyph} />
      {text !== undefined && (
        <span className={isEarly ? "glyph-text early" : "glyph-text"} aria-hidden="true">
          {text}
        </span>
      )}
    </button>
  );
}
