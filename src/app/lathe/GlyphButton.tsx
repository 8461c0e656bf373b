import { Glyph, type GlyphName } from "./Glyph.tsx";

/** A button that shows a glyph and is called by its name. */
export function GlyphButton({ glyph, name, onPress, pressed, disabled }: {
  readonly glyph: GlyphName;
  readonly name: string;
  readonly onPress: () => void;
  /** For switches: on or off. */
  readonly pressed?: boolean;
  readonly disabled?: boolean;
}) {
  return (
    <button type="button" className="button icon" aria-label={name} title={name} aria-pressed={pressed} disabled={disabled} onClick={onPress}>
      <Glyph name={glyph} />
    </button>
  );
}
