import { useEffect, useRef } from "react";
import { markFresh } from "../approach/fresh-block.ts";
import type { CycleNumber } from "../../cycles/index.ts";
import { Icon } from "../Icon.tsx";
import { useSettings } from "../settings/settings.ts";
import { useTexts } from "../settings/use-texts.ts";
import { inserted } from "./block-edits.ts";
import { palette, type Offered } from "./palette.ts";
import { editProgram, useSession } from "./session.ts";

const groups = [...new Set(palette.map((offered) => offered.group))];

/** All kinds of blocks; choosing one puts it behind the open block and opens its dialog. */
export function Palette({ index, done }: { readonly index: number; readonly done: () => void }) {
  const t = useTexts();
  const language = useSettings((s) => s.language);
  const program = useSession((s) => s.reading.program);
  const box = useRef<HTMLDivElement>(null);
  useEffect(() => box.current?.querySelector<HTMLElement>("button")?.focus({ preventScroll: true }), []);

  const put = (offered: Offered) => {
    const made = offered.make(language);
    if (made.kind === "approach") markFresh(index + 1);
    editProgram(inserted(program, index + 1, made), null, index + 1);
    done();
  };
  const nameOf = ({ kind, cycle }: Offered) =>
    cycle === undefined ? t.editor.kinds[kind] : t.editor.cycleNumber(cycle, t.cycles.of[cycle as CycleNumber].name);
  return (
    <div className="palette" ref={box} role="group" aria-label={t.editor.palette} onKeyDown={(event) => {
      if (event.key === "Escape") done();
    }}>
      <header className="block-head">
        <h2>{t.editor.palette}</h2>
        <button type="button" className="button icon plain" aria-label={t.page.close} onClick={done}>
          <Icon name="close" />
        </button>
      </header>
      {groups.map((group) => (
        <section key={group} aria-label={t.editor.groups[group]}>
          <h3 className="panel-title">{t.editor.groups[group]}</h3>
          <div className="palette-kinds">
            {palette.filter((offered) => offered.group === group).map((offered) => (
              <button key={`${offered.kind} ${offered.cycle ?? ""}`} type="button" className="button" onClick={() => put(offered)}>
                {/^[A-Z]/.test(offered.kind) && <b className="number">{offered.kind}</b>} {nameOf(offered)}
              </button>
            ))}
          </div>
        </section>
      ))}
    </div>
  );
}
