/* The guide and the glossary, and their parts in the prompts. */

export const fetchGuidePage = () => import("./GuidePage.tsx");
export const fetchPromptMore = () => import("./PromptMore.tsx");
export const fetchSetupStart = () => import("./SetupStart.tsx");
