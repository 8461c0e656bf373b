import type { ShopWords } from "../../shop-words.ts";

export const shopWords: ShopWords = {
  groups: {
    special: ["réglage", "système de coordonnées", "réinitialiser"],
    longitudinal: ["chariotage", "alésage", "aléser", "cylindrage", "diamètre"],
    transverse: ["dressage", "dresser", "surfaçage", "face", "facette"],
    recessTurning: ["gorge", "rainure", "saignée"],
    recessing: ["gorge", "rainure", "saignée", "tronçonnage", "tronçonner", "plongée"],
    thread: ["filetage", "fileter", "filet", "vis", "pas"],
  },
  free: ["profil", "forme", "dégagement", "contour"],
  same: [
    ["épaulement", "gradin", "portée"],
    ["gorge", "rainure", "saignée"],
    ["contour", "profil"],
  ],
};
