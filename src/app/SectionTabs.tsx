import type { ReactNode } from "react";
import { Tab, TabList, TabPanel, Tabs } from "react-aria-components/Tabs";
import { showSection, type WorkSection } from "./place.ts";

interface Section {
  readonly section: WorkSection;
  readonly name: string;
  readonly content: ReactNode;
  /** Stays in the page while another one is open, and keeps what it remembers. */
  readonly stays?: boolean;
  /** A count beside the name, with its colour. */
  readonly badge?: { readonly count: number; readonly severity: "error" | "warning" | "info" };
}

/** Panels that take turns. */
export function SectionTabs({ name, tabs, open }: { readonly name: string; readonly tabs: readonly Section[];
  readonly open: WorkSection })
{
  return (
    <Tabs className="sections" selectedKey={open} onSelectionChange={(key) => showSection(key as WorkSection)}>
      <TabList className="tabs" aria-label={name}>
        {tabs.map(({ section, name: label, badge }) => (
          <Tab key={section} id={section} className="tab">
            {label}
            {badge && badge.count > 0 && <span className={`badge number ${badge.severity}`}>{badge.count}</span>}
          </Tab>
        ))}
      </TabList>
      {tabs.map(({ section, stays = false, content }) => (
        <TabPanel key={section} id={section} className={`panel panel-${section}`} shouldForceMount={stays}>{content}</TabPanel>
      ))}
    </Tabs>
  );
}
