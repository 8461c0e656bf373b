/* All works of this device. */

export const fetchRestoreDialog = () => import("./RestoreDialog.tsx");
export const fetchOtherTabPage = () => import("./OtherTabPage.tsx");
export const fetchThisDevice = () => import("./ThisDevice.tsx");
export const fetchDiedPage = () => import("./DiedPage.tsx");
export const fetchWorksPage = () => import("./WorksPage.tsx");
export const fetchCrashHelp = () => import("./crash/CrashHelp.tsx");
export const fetchExportWorks = () => import("./export-works.ts");
