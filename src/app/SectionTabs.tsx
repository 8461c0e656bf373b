import { useRef, type KeyboardEvent, type ReactNode } from "react";
import { showSection, type WorkSection } from "./place.ts";

interface Tab {
  readonly section: WorkSection;
  readonly name: string;
  readonly content: ReactNode;
  /** Stays in the page while another one is open, and keeps what it remembers. */
  readonly stays?: boolean;
  /** A count beside the name, with its colour. */
  readonly badge?: { readonly count: number; readonly severity: "error" | "warning" | "info" };
}

/** Panels that take turns. Arrow keys move along the tabs, as everywhere. */
export function SectionTabs({ name, tabs, open }: { readonly name: string; readonly tabs: readonly Tab[]; readonly open: WorkSection }) {
  const list = useRef<HTMLDivElement>(null);
  const at = tabs.findIndex((tab) => tab.section === open);
  const onKeyDown = (event: KeyboardEvent) => {
    const by = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
    const next = tabs[(at + by + tabs.length) % tabs.length];
    if (by === 0 || !next) return;
    event.preventDefault();
    showSection(next.section);
    list.current?.querySelector<HTMLElement>(`#tab-${next.section}`)?.focus();
  };
  return (
    <>
      <div className="tabs" role="tablist" aria-label={name} ref={list} onKeyDown={onKeyDown}>
        {tabs.map(({ section, name: label, badge }) => (
          <button key={section} type="button" role="tab" id={`tab-${section}`} className="tab" aria-selected={section === open}
            aria-controls={`panel-${section}`} tabIndex={section === open ? 0 : -1} onClick={() => showSection(section)}
          >
            {label}
            {badge && badge.count > 0 && <span className={`badge number ${badge.severity}`}>{badge.count}</span>}
          </button>
        ))}
      </div>
      {tabs.filter(({ section, stays }) => stays === true || section === open).map(({ section, content }) => (
        <div key={section} className={`panel panel-${section}`} role="tabpanel" id={`panel-${section}`} aria-labelledby={`tab-${section}`}
          hidden={section !== open}
        >
          {content}
        </div>
      ))}
    </>
  );
}
