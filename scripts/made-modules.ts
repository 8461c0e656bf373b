import { runnerImport, type Plugin } from "vite";

/** Modules that a script makes when the page is built, by ids that begin with one name. */
function madeModules(id: string, script: string, made: string): Plugin {
  let modules: Promise<Readonly<Record<string, string>>> | null = null;
  const make = () =>
    (modules ??= runnerImport<Readonly<Record<string, () => Readonly<Record<string, string>>>>>(
      new URL(script, import.meta.url).pathname,
      {
        configFile: false,
        logLevel: "error",
      },
    ).then(({ module }) => module[made]?.() ?? {}));
  return {
    name: id,
    resolveId: (asked) => (asked.startsWith(id) ? `\0${asked}` : undefined),
    load: async (asked) => (asked.startsWith(`\0${id}`) ? (await make())[asked.slice(1)] : undefined),
    hotUpdate() {
      modules = null;
    },
  };
}

/** What the first screen has to know of the catalogue and of its texts, without them. */
export const cycleMenu = madeModules("virtual:cycle-menu", "./menu.ts", "menuModules");
/** What it shows of the programs that ship with it, without running them. */
export const startPictures = madeModules("virtual:start-pictures", "./start-pictures.ts", "pictureModules");
/** What the list of lessons has to know of the course, without its files. */
export const courseIndex = madeModules("virtual:course-index", "./course-index.ts", "courseModules");
