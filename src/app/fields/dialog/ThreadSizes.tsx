import { useId, useRef, useState } from "react";
import { sizesNamed, type ThreadSize } from "../../../cycles/thread-sizes.ts";
import { formatNumber } from "../../../i18n/number.ts";
import { useSettings } from "../../base/settings/settings.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { ThreadPicture } from "./ThreadPicture.tsx";
import "./thread-sizes.css";

/** Most names shown; another letter narrows the list. */
const SHOWN = 6;

/** Finds a thread by its name and fills the prompts. */
export function ThreadSizes({
  line,
  take,
}: {
  readonly line: number | null;
  readonly take: (size: ThreadSize) => void;
}) {
  const {
    dialog: { sizes: t },
  } = useTexts();
  const language = useSettings((s) => s.language);
  const id = useId();
  const input = useRef<HTMLInputElement>(null);
  const [typed, type] = useState("");
  const [taken, setTaken] = useState<ThreadSize | null>(null);
  const found = sizesNamed(typed).slice(0, SHOWN);
  const number = (n: number) => formatNumber(language, n);
  const choose = (size: ThreadSize) => {
    take(size);
    setTaken(size);
    type("");
    // The list closes, and the focused button with it.
    input.current?.focus({ preventScroll: true });
  };
  return (
    <section className="thread-sizes" aria-label={t.title}>
      <div className="thread-size">
        <label htmlFor={id} className="small soft">
          {t.title}
        </label>
        <input
          id={id}
          ref={input}
          className="input"
          type="search"
          autoComplete="off"
          spellCheck={false}
          placeholder={t.example}
          value={typed}
          onChange={(event) => {
            type(event.target.value);
            setTaken(null);
          }}
          onKeyDown={(event) => {
            const first = found[0];
            if (event.key !== "Enter" || !first) return;
            event.preventDefault();
            choose(first);
          }}
        />
      </div>
      <ThreadPicture line={line} />
      {found.length > 0 && (
        <div className="thread-sizes-found" role="group" aria-label={t.found}>
          {found.map((size) => (
            <button key={size.name} type="button" className="button" onClick={() => choose(size)}>
              <strong>{size.name}</strong>{" "}
              <span className="small soft number">
                ⌀{number(size.outside.diameter)} · {number(size.pitch)}
              </span>
            </button>
          ))}
        </div>
      )}
      <p className="small soft" role="status">
        {typed !== "" && found.length === 0 && t.none}
        {taken && t.taken(taken.name, number(taken.angle))}
      </p>
    </section>
  );
}
