import { strToU8 } from "fflate";

/**
 * What links say again and again: packing begins with it, so that a link holds only what is its own. It belongs to links of the first
 * form and may never change: a link that was packed with other words can not be read.
 */
const WORDS = [
  '"DZL":"0.","DXL":"0.","DRS":"0.","ORI":"90","DCW":"0.","CUTWIDTH":"3","L":"120","DL":"0","DR":"0","LCUTS":"40","PITCH":"1.5","TYPE',
  '":"MILL""TYPE":"THREAD","TYPE":"RECESS","TYPE":"RECTURN","TYPE":"BUTTON","TYPE":"DRILL","TYPE":"TAP","TYPE":"CENTER","axis":"X","a',
  'xis":"Z","head":""},"T":"1","NAME":"","ZL":"","XL":"","RS":"0.4","TO":"3","T-ANGLE":"93","P-ANGLE":"55","CUTLENGTH":"10","TYPE":"F',
  'INISH","width":"20","length":"100","offsetZ":"0","offsetX":"-6","tools":[{"id":"r1","cells":{"T":"1","NAME":"ROUGH-80-R08","RS":"0',
  '.8","TO":"3","T-ANGLE":"95","P-ANGLE":"80","CUTLENGTH":"12","TYPE":"ROUGH","width":"25","length":"120","offsetZ":"-4","offsetX":"8',
  '"}},"control":"TNC7","kind":"CTP","kind":"RND","kind":"CHF","kind":"CR","form":"RADIAL","incrementalX":true,"incrementalZ":true,"s',
  'econd":true,"tangent":true,{"id":"e1","kind":"L","x":"60","z":"-40","r":"","turn":"cw","incrementalX":false,"incrementalZ":false,"',
  'angle":"","length":"","tangent":false,"second":false,"form":"","words":{}},"turn":"ccw","parameters":{"Q5":"10"},"drafts":{"812":{',
  '"Q215":"0","Q460":"2","Q491":"60","Q492":"0","Q493":"50","Q494":"-55","Q495":"5","Q463":"3","Q478":"0.3","Q483":"0.4","Q484":"0.2"',
  ',"Q505":"0.2","Q506":"0","Q500":"0","Q501":"0","Q502":"0.5","Q503":"0","Q504":"0.5","Q496":"0","Q498":"0","Q499":"0","Q462":"0","Q',
  '467":"0","Q510":"0.8","Q211":"3","Q479":"0.5","Q457":"0","Q458":"0","Q464":"1","Q472":"2","Q473":"0","Q465":"4","Q466":"4","Q475":',
  '"0","Q476":"30"}},"tool":1,"blank":{"outside":"62","bore":"0","length":"95","allowance":"2"},"start":{"x":"100","z":"2"},"spindle"',
  ':{"mode":"surface","speed":"800","cuttingSpeed":"180","limit":"2500"},"perRevolution":true,"rapid":"10000","contour":[],"layout":"',
  'tnc640","ncLanguage":"en",{"work":{"name":".h","cycle":,"text":"","files":[{"name":"","encoding":"windows-1252","skipMarked":true,',
  '"encoding":"utf-8","FUNCTION TURNDATA CORR-TCS:Z/X DXL+0 DZL+0\\nCALL PGM \\nCALL LBL 1 REP\\nLBL \\"CONTOUR\\"\\nLBL 1\\nLBL 0\\nCY',
  "CL DEF 14.0 CONTOUR\\nCYCL DEF 14.1 CONTOUR LABEL2\\nFN 0: Q1 = \\n* - \\nSTOP M0\\nTOOL DEF 1 L+0 R+5\\nTOOL CALL 1 Z S2000 F500\\n",
  "APPR LT X+ Y+ LEN R0 RL F250\\nAPPR CT CCA90 R+5 DEP LCT M303\\nM304\\nCC X+0 Y+0\\nCR X+ Z- R+ DR+\\nCR R- DR-\\nRND R2\\nCHF 1\\nM",
  "136\\nM137\\nM30\\nM305\\nM140 MB MAX\\nBLK FORM 0.1 Z X+0 Y+0 Z-20\\nBLK FORM 0.2 X+100 Y+100 Z+0\\nBLK FORM CYLINDER Z D62 L95 DIS",
  "T+2 DI20\\nFUNCTION MODE MILL\\nFUNCTION MODE TURN\\nFUNCTION TURNDATA SPIN VCONST:OFF S900\\nFUNCTION TURNDATA SPIN VCONST:ON VC:18",
  "0 SMAX2500\\nCYCL DEF 8 EXPANDED RECESSING, RADIAL ~\\nCYCL DEF 8 THREAD EXTENDED ~\\nCYCL DEF 8 SHOULDER, FACE ~\\nCYCL DEF 8 TURN ",
  "CONTOUR LONGITUDINAL ~\\nCYCL DEF 8 ADJUST XZ SYSTEM ~\\n    Q497=+0 ;PRECESSION ANGLE ~\\n    Q498=+0 ;REVERSE TOOL ~\\n    Q530=+0",
  " ;INCLINED MACHINING ~\\n    Q531=+0 ;ANGLE OF INCIDENCE ~\\n    Q532=+750 ;FEED RATE ~\\n    Q533=+0 ;PREFERRED DIRECTION ~\\n    Q",
  "535=+3 ;ECCENTRIC TURNING ~\\nCYCL DEF 8 SHOULDER, LONGITDNL. ~\\nCYCL DEF 8 SHOULDER, LONG. EXT. ~\\n    Q215=+0 ;MACHINING OPERATI",
  "ON ~\\n    Q460=+2 ;SAFETY CLEARANCE ~\\n    Q491=+60 ;DIAMETER AT CONTOUR START ~\\n    Q492=+0 ;CONTOUR START IN Z ~\\n    Q493=+5",
  "0 ;DIAMETER AT END OF CONTOUR ~\\n    Q494=-55 ;CONTOUR END IN Z ~\\n    Q495=+5 ;ANGLE OF CYLINDER SURFACE ~\\n    Q501=+1 ;TYPE OF",
  " STARTING ELEMENT ~\\n    Q502=+0.5 ;SIZE OF STARTING ELEMENT ~\\n    Q500=+1.5 ;RADIUS OF CONTOUR EDGE ~\\n    Q496=+0 ;ANGLE OF FA",
  "CE ~\\n    Q503=+1 ;TYPE OF END ELEMENT ~\\n    Q504=+0.5 ;SIZE OF END ELEMENT ~\\n    Q463=+3 ;MAX. CUTTING DEPTH ~\\n    Q478=+0.3",
  " ;ROUGHING FEED RATE ~\\n    Q483=+0.4 ;OVERSIZE FOR DIAMETER ~\\n    Q484=+0.2 ;OVERSIZE IN Z ~\\n    Q505=+0.2 ;FINISHING FEED RAT",
  "E ~\\n    Q506=+0 ;CONTOUR SMOOTHING\\nL X+72 Z+2 R0 FMAX M303\\nCYCL CALL\\nL Z+10 FMAX M3\\nCYCL CALL M3\\n0 BEGIN PGM  MM\\n1 BLK",
  " FORM CYLINDER Z D\\n2 FUNCTION MODE TURN\\n3 TOOL CALL 1\\n4 FUNCTION TURNDATA SPIN VCONST:ON VC:\\n5 M136\\n6 L X+\\n10 \\n11 \\n1",
  '2 \\n13 \\n14 \\n15 \\n16 \\n17 \\n18 \\n19 L X+ Z- R0 FMAX\\n20 L Z+2\\n21 M30\\nEND PGM  MM\\n"',
].join("");

export const COMMON = strToU8(WORDS);
