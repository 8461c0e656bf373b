import { readJson } from "../../program/files/bounded.ts";
import { createContext, memo, useContext, useMemo, type ReactNode } from "react";
import { Tab, TabList, TabPanel, Tabs } from "react-aria-components/Tabs";
import { useActions } from "../base/actions.ts";
import { showSection, type WorkSection } from "./place.ts";

interface Section {
  readonly section: WorkSection;
  readonly name: string;
  readonly content: ReactNode;
  /** Stays mounted while another section is open, and keeps its state. */
  readonly stays?: boolean;
  /** A count beside the name, with its colour. Its place is kept free at 0: the tabs stay put when findings arrive. */
  readonly badge?: { readonly count: number; readonly severity: "error" | "warning" | "info" };
}
type Head = Omit<Section, "content">;

const Contents = createContext<ReadonlyMap<WorkSection, ReactNode>>(new Map());
const Content = ({ of }: { readonly of: WorkSection }): ReactNode => useContext(Contents).get(of);

/** The tabs and their panels: they render when a tab changes, not with every key typed in one. */
const Frame = memo(function Frame({
  name,
  heads,
  open,
}: {
  readonly name: string;
  readonly heads: string;
  readonly open: WorkSection;
}) {
  const all = readJson(heads) as readonly Head[];
  return (
    <Tabs className="sections" selectedKey={open} onSelectionChange={(key) => showSection(key as WorkSection)}>
      <TabList className="tabs" aria-label={name}>
        {all.map(({ section, name: label, badge }) => (
          <Tab key={section} id={section} className="tab">
            {label}
            {badge && <span className={`badge number ${badge.severity}`}>{badge.count > 0 && badge.count}</span>}
          </Tab>
        ))}
      </TabList>
      {all.map(({ section, stays = false }) => (
        <TabPanel key={section} id={section} className={`panel panel-${section}`} shouldForceMount={stays}>
          <Content of={section} />
        </TabPanel>
      ))}
    </Tabs>
  );
});

/** Tabs with one panel at a time. */
export function SectionTabs({
  name,
  tabs,
  open,
}: {
  readonly name: string;
  readonly tabs: readonly Section[];
  readonly open: WorkSection;
}) {
  useActions(
    tabs.map(({ section, name: label }) => ({
      id: `do.section ${section}` as const,
      name: label,
      run: () => showSection(section),
    })),
  );
  const contents = useMemo(() => new Map(tabs.map(({ section, content }) => [section, content])), [tabs]);
  return (
    <Contents value={contents}>
      <Frame name={name} open={open} heads={JSON.stringify(tabs.map(({ content: _, ...head }) => head))} />
    </Contents>
  );
}
