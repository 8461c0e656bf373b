import { useRef, useState, type MouseEvent } from "react";
import { Icon } from "../app/base/Icon.tsx";
import { useTexts } from "../app/base/settings/use-texts.ts";
import { useFingers } from "../app/base/use-media.ts";
import { useEditor } from "../app/document/store.ts";
import { useOpenCall } from "../app/place/open-call.ts";
import { showKeys, showWhich } from "../app/place/place.ts";
import "./help-menu.css";

/** Space between the button and its menu, px. */
const APART = 4;

/** The cycle of the open job, or the one whose block was open last in the open program. */
function useOpenCycle(): number | null {
  const job = useEditor((s) => s.job?.cycle);
  const work = useEditor((s) => s.work);
  const call = useOpenCall((s) => s.call);
  return job ?? (work !== null && call?.work === work ? call.cycle : null);
}

/** The header's menu of the guide: the open cycle, cutting data and advice, glossary, course, shortcuts. */
export function HelpMenu() {
  const { helpMenu: t, page, start } = useTexts("first");
  const [open, setOpen] = useState(false);
  const button = useRef<HTMLButtonElement>(null);
  const menu = useRef<HTMLDivElement>(null);
  const cycle = useOpenCycle();
  const fingers = useFingers();
  const close = () => menu.current?.hidePopover();
  const onMenu = (event: MouseEvent) => {
    if ((event.target as Element).closest("a, button")) close();
  };
  /** The menu is in the top layer, so it is placed by hand: below its button, within the page. */
  const place = () => {
    const at = button.current?.getBoundingClientRect();
    if (!at || !menu.current) return;
    menu.current.style.top = `${at.bottom + APART}px`;
    menu.current.style.right = `${Math.max(APART, document.documentElement.clientWidth - at.right)}px`;
  };
  const links = [
    ...(cycle === null ? [] : [[`#/guide/${cycle}`, t.cycle(cycle)] as const]),
    ["#/guide", t.guide],
    ["#/guide/advice", start.beyondAll.advice.what],
    ["#/glossary", start.doors.glossary],
    ["#/course", t.course],
  ] as const;
  return (
    <>
      <button
        ref={button}
        type="button"
        className="button plain new-program"
        aria-label={t.open}
        title={t.long}
        aria-expanded={open}
        popoverTarget="help-menu"
      >
        <Icon name="question" /> <span>{t.open}</span>
      </button>
      <div
        ref={menu}
        id="help-menu"
        popover="auto"
        className="help-menu"
        role="group"
        aria-label={t.long}
        onBeforeToggle={place}
        onToggle={(event) => setOpen(event.newState === "open")}
        onClick={onMenu}
      >
        {open && (
          <ul>
            {links.map(([href, name]) => (
              <li key={href}>
                <a className="help-way" href={href}>
                  {name}
                </a>
              </li>
            ))}
            <li>
              <button type="button" className="help-way" onClick={() => showWhich()}>
                {page.start.which}
              </button>
            </li>
            {!fingers && (
              <li>
                <button type="button" className="help-way" onClick={() => showKeys("everywhere")}>
                  {page.keys} <kbd>?</kbd>
                </button>
              </li>
            )}
          </ul>
        )}
      </div>
    </>
  );
}
