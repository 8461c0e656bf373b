import type { CourseDrawingTexts } from "../../../i18n/en/course-drawing.ts";
import type { ListedSize, PrintWords } from "../../../view/drawing/print-sizes.ts";

/** The sizes of a drawing as a list, for screen readers, and for notes without room. */
export function SizeList({
  id,
  list,
  general,
  words,
  t,
}: {
  readonly id: string;
  readonly list: readonly ListedSize[];
  readonly general: string | null;
  readonly words: PrintWords;
  readonly t: CourseDrawingTexts;
}) {
  const z = (value: number) => words.position(value);
  const place = (at: readonly number[]) => {
    const [from, to] = at;
    if (from === undefined) return "";
    return at.length === 2 && to !== undefined ? t.atTwo(z(from), z(to)) : t.atMany(at.map(z).join(", "));
  };
  return (
    <details className="workshop-list">
      <summary>{t.list}</summary>
      <ul id={id}>
        {list.map(({ kind, size, at }, i) => (
          <li key={i}>
            {t.kinds[kind]} <b className="number">{size.text}</b>
            {size.upper !== undefined && size.lower !== undefined && `, ${t.deviations(size.upper, size.lower)}`}
            {kind !== "length" && (
              <span className="soft">
                {place(kind === "chamfer" || kind === "radius" || kind === "angle" ? at.slice(0, 1) : at)}
              </span>
            )}
          </li>
        ))}
        {general !== null && <li>{t.all(general)}</li>}
      </ul>
    </details>
  );
}
