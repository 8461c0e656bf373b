import { Icon } from "../app/base/Icon.tsx";
import { Menu, type MenuItem, type MenuLink } from "../app/base/Menu.tsx";
import { useTexts } from "../app/base/settings/use-texts.ts";
import { useFingers } from "../app/base/use-media.ts";
import { useEditor } from "../app/document/store.ts";
import { useOpenCall } from "../app/place/open-call.ts";
import { showKeys, showWhich } from "../app/place/place.ts";

const NONE: readonly MenuItem[] = [];

/** The cycle of the open job, or the one whose block was open last in the open program. */
function useOpenCycle(): number | null {
  const job = useEditor((s) => s.job?.cycle);
  const work = useEditor((s) => s.work);
  const call = useOpenCall((s) => s.call);
  return job ?? (work !== null && call?.work === work ? call.cycle : null);
}

/**
 * The header's menu of the guide: the open cycle, cutting data and advice, glossary, course, shortcuts. `folded`: what
 * the header has no room for on a phone; the menu is then that of the header.
 */
export function HelpMenu({ folded = NONE }: { readonly folded?: readonly MenuItem[] }) {
  const { helpMenu: t, page, start } = useTexts("first");
  const cycle = useOpenCycle();
  const fingers = useFingers();
  const links: readonly MenuLink[] = [
    ...(cycle === null ? [] : [{ name: t.cycle(cycle), href: `#/guide/${cycle}` }]),
    { name: t.guide, href: "#/guide" },
    { name: start.beyondAll.advice.what, href: "#/guide/advice" },
    { name: start.doors.glossary, href: "#/glossary" },
    { name: t.course, href: "#/course" },
  ];
  const actions: readonly MenuItem[] = [
    { name: page.start.which, opens: "dialog", go: () => showWhich() },
    ...(fingers
      ? []
      : [{ name: page.keys, shortcut: "?", opens: "dialog", go: () => showKeys("everywhere") } as const]),
  ];
  const isFolded = folded.length > 0;
  const name = isFolded ? t.menu : t.open;
  return (
    <Menu
      name={name}
      hint={isFolded ? t.menu : t.long}
      className="button plain new-program"
      groups={[folded, links, actions]}
      label={
        <>
          <Icon name={isFolded ? "menu" : "question"} /> <span>{name}</span>
        </>
      }
    />
  );
}
