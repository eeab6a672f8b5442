///
/// # Derived from the gap profile
///
/// Lengths in mm; equation numbers of I. Argatov, Mech. Res. Commun. 38 (2011) 29–33, doi 10.1016/j.mechrescom.2010.11.006.
///
/// ```text
/// gap, mm               Φ(r)   = 0.075 r² + 1.40625e-4 r⁴ + 6.4453125e-7 r⁶ + 3.936767578125e-9 r⁸ + 2.739715576171875e-11 r¹⁰ + 2.0517826080322267e-13 r¹² + 1.6115248203277588e-15 r¹⁴ + 1.309244055300951e-17 r¹⁶ + 1.0910117416642606e-19 r¹⁸ + 9.273546740587335e-22 r²⁰ + 8.00896072814794e-24 r²² + 7.007838130931532e-26 r²⁴
/// approach, mm          δ₀(a)  = 0.0375 a² + 4.6875e-5 a⁴ + 1.611328125e-7 a⁶ + 7.87353515625e-10 a⁸ + 4.566192626953125e-12 a¹⁰ + 2.931118011474609e-14 a¹² + 2.0144060254096985e-16 a¹⁴ + 1.4547156170010567e-18 a¹⁶ + 1.0910117416642607e-20 a¹⁸ + 8.430497036897578e-23 a²⁰ + 6.674133940123284e-25 a²² + 5.390644716101178e-27 a²⁴    (10)
/// slope of the approach δ₀′(a) = 0.075 a + 1.875e-4 a³ + 9.66796875e-7 a⁵ + 6.298828125e-9 a⁷ + 4.566192626953125e-11 a⁹ + 3.517341613769531e-13 a¹¹ + 2.8201684355735777e-15 a¹³ + 2.3275449872016907e-17 a¹⁵ + 1.9638211349956691e-19 a¹⁷ + 1.6860994073795155e-21 a¹⁹ + 1.4683094668271224e-23 a²¹ + 1.2937547318642829e-25 a²³
/// load integral, mm⁵    J(a)   = 0.00625 a⁶ + 1.171875e-5 a⁸ + 4.833984375e-8 a¹⁰ + 2.62451171875e-10 a¹² + 1.6307830810546874e-12 a¹⁴ + 1.0991692543029785e-14 a¹⁶ + 7.833801209926605e-17 a¹⁸ + 5.818862468004227e-19 a²⁰ + 4.4632298522628844e-21 a²² + 3.512707098707324e-23 a²⁴ + 2.82367205159062e-25 a²⁶ + 2.310276306900505e-27 a²⁸    (14)
/// log kernel, mm³       L(x)   = 0.0046875 x⁴ + 3.90625e-6 x⁶ + 1.007080078125e-8 x⁸ + 3.936767578125e-11 x¹⁰ + 1.9025802612304688e-13 x¹² + 1.046827861240932e-15 x¹⁴ + 6.295018829405308e-18 x¹⁶ + 4.040876713891824e-20 x¹⁸ + 2.7275293541606515e-22 x²⁰ + 1.9160220538403586e-24 x²² + 1.3904445708590175e-26 x²⁴ + 1.0366624454040728e-28 x²⁶    (28)
/// pressure kernel, mm³  G(a,r) = 0.00234375 a⁴ K(2, r/a) + 1.953125e-6 a⁶ K(4, r/a) + 5.035400390625e-9 a⁸ K(6, r/a) + 1.9683837890625e-11 a¹⁰ K(8, r/a) + 9.512901306152344e-14 a¹² K(10, r/a) + 5.23413930620466e-16 a¹⁴ K(12, r/a) + 3.147509414702654e-18 a¹⁶ K(14, r/a) + 2.020438356945912e-20 a¹⁸ K(16, r/a) + 1.3637646770803257e-22 a²⁰ K(18, r/a) + 9.580110269201793e-25 a²² K(20, r/a) + 6.952222854295087e-27 a²⁴ K(22, r/a) + 5.183312227020364e-29 a²⁶ K(24, r/a), K(n,q) = n − (n+2) q² + 2 qⁿ⁺²    (28)
/// contact radius, mm    the a with (π m/4) J(a) = F(t) + χ ∫F dτ    (14)
/// ```
///
/// Admissible for every contact radius (all coefficients are positive); used up to 5 mm.
///
/// Surfaces are expanded in powers of r up to r²⁴. Up to r = 5 mm this changes the gap by at most 6.06e-10 of its value.
///
/// The contact radius is a polynomial from a table of 24576 bytes, in single precision of 8192, where J is between 6.9e-18 and 1.3e2; elsewhere it is iterated.
///
/// Operations of a call:
///
/// Double words round a result only once. A × of them takes 24 plain operations, or 9 if the processor multiplies and adds in one; a + takes 11.
///
/// ```text
/// gap                   13 ×, 11 + of double words
/// approach              13 ×, 11 + of double words
/// slope of the approach 13 ×, 11 + of double words
/// load integral         a routine of the run-time crate
/// log kernel            a routine of the run-time crate
/// pressure kernel       a routine of the run-time crate
/// ```
struct Spheres;
#[allow(
    deprecated,
    single_use_lifetimes,
    reason = "they concern the struct, which is repeated here"
)]
#[allow(clippy::approx_constant, reason = "a coefficient near a famous number is none")]
const _: () = {
    use ::cartcontact::generated::root as __cartcontact;
    static __CURVES: __cartcontact::generated::DoubleCurves = __cartcontact::generated::Table {
        quarters: __cartcontact::generated::Quarters {
            first: -228,
            count: 256,
        },
        single: __cartcontact::generated::Quarters {
            first: -228,
            count: 0,
        },
        rows: __cartcontact::generated::Rows(
            *b"...",
        ),
    };
    static __CURVES_OF_SINGLE: __cartcontact::generated::SingleCurves = __cartcontact::generated::Table {
        quarters: __cartcontact::generated::Quarters {
            first: -228,
            count: 256,
        },
        single: __cartcontact::generated::Quarters {
            first: -228,
            count: 256,
        },
        rows: __cartcontact::generated::Rows(
            *b"\x07P*@g\xCA\xE32\x9A\xEB\xC8>\0A\x15\xBE\xD1C\xA2=\x05hL\xBDod\r=\xAE&\xCB\xBC\xB0\x130@\xF2@m3{\xE5\xA9>\xBA\x90\xCE\xBDv\xC17=\x85f\xBD\xBC\x1DXU<o\x8B\xFA\xBB\xC3\x055@z\xF5\x163\x9F\xC0\x93>\x8C\x08\x98\xBD\xCF\xE3\xE4<\xC9\xA1G\xBC\x1C\xBF\xBD; q<\xBB8^9@q\x17\x9D3:\x17\x83>\xF6\xD8i\xBD[\x91\x98<>\xA7\xE6\xBB\x10\xAC=;\xA51\xA3\xBA\xE2\r?@\xEA\x02\xA2\xB3\xC4\x1A\xE1>|Z'\xBEn\xFA\xB5=`Ce\xBD\xE5\x98\x1E=\xCF\xE1\xE3\xBC\x0C\x83E@\xE6s\xE93\xDAQ\xBE>\xEE\x98\xE7\xBD<\x11N=\xCDk\xD4\xBC\xE6Jo<\"\x84\x0C\xBC;\rK@N\x01H\xB3<~\xA5>\x1Br\xAA\xBDyU\0=\xB3\xE2_\xBC\xC6\xD0\xD4;-]S\xBB1\xEBO@\x1F\x0B\xC9\xB3j\xD0\x92>~\x13\x83\xBD-\x13\xAB<\x10U\x01\xBCE\xB9T;\xC3\t\xB7\xBARIV@{\xD5\xEF3\xAE\x10\xFC>2\x98;\xBE\x18\n\xCC=\x9A\x8B\x80\xBD\xEB\xDC1=z\x94\xFF\xBCR\x84]@\x14\x14\xB5\xB33\x13\xD5>\xB8\xCA\x01\xBE\xE8\x07g='0\xEE\xBC\n,\x86<\x07\x96\x1D\xBC\xEF\xB7c@\xC8\xB2\xAC\xB3\xDB?\xB9>\xB7\x06\xBF\xBD\xE3\xDE\x0F=)\x07{\xBC\xAA\xA3\xEE;<\x07m\xBB\x87*i@u\x9D\xDC3\xD9P\xA4>C\xE4\x92\xBD0\xC6\xBF<\xF4\0\x11\xBCA\x86n;\xE6@\xCD\xBA\xCEJp@;\xCE\x84\xB3*\x07\r?+5R\xBEA\xB5\xE4=^\x1C\x90\xBD$lG=\x89J\x0F\xBD\xC8ax@\x98\xE6\\2N^\xEE>kk\x11\xBE\xF4w\x81=\xE4\x80\x05\xBDol\x96<?\xB00\xBC\xA9Q\x7F@?]\xE52\xAF1\xCF>\xF7\0\xD6\xBD\x11<!=x\xB0\x8C\xBCF\xC3\x05<!\xDF\x84\xBB\xA7\xB4\x82@\xFB\x91s2\\\xBE\xB7>^\x8B\xA4\xBD\x13\xE7\xD6<1\x86\"\xBC\x9D\xB0\x85;\x03\x1B\xE6\xBA\x7F\xB0\x86@\x05\x17\n\xB1\xA6\xA8\x1D?=pk\xBE\xB4!\0>\x18\x82\xA1\xBDZ\x87_=\xD9\xA0 \xBD\xE85\x8B@\xA2&a\xB3\xE81\x05?I\xD9\"\xBE\x88\x0C\x91=\x91\x9A\x15\xBD\xFD\x96\xA8<?\x0CF\xBC\x15\x16\x8F@\x80jm\xB4G{\xE7>\xC4\x9E\xEF\xBD\x19\x9E4=\t\xA4\x9D\xBCL\xE7\x15<\xF5\xEB\x94\xBB2}\x92@\xC2\xCE\xB8\xB3\xC19\xCD>\xB97\xB8\xBD\x81\xB6\xF0<\x1D\x176\xBCG\xCF\x95;\xD6\xF0\0\xBB\x0F\xF0\x96@Dd+\xB4>\x060?\xA3\xC5\x83\xBE=\x80\x0F>'\xEE\xB4\xBDFtz=\xFC\xFF3\xBD\0\xFC\x9B@\xBFu\xC23\x89\xA4\x14?\xDC@6\xBE\xDBk\xA2=\x18\x92'\xBD\x85\xDF\xBC<\xD8\xE7]\xBC\x05O\xA0@\x11\xCE{\xB4C\x1C\x01?0\x10\x06\xBE\x988J=\0\x8D\xB0\xBCb\xEB'<\x06\xD8\xA6\xBB\x92\x1A\xA4@\x01O\x0C4\xF0\xD7\xE4>\xE1\x19\xCE\xBD\x19\xBC\x06=\xFA\xE8K\xBC\n\xCC\xA7;\xC6q\x10\xBB%\x11W;\xF3\xDE\xC7-\xEA\xE4\xFE9\x7F\xCF<\xB9\n\x1E\xCD8\xB1$\x81\xB8\xB8\x9D28\x16K\0\xB8\xADa^;&|3.\x89\xA4\xD79K\xB1\x02\xB9SVh8\xB8_\xEF\xB7\xC5\xC7\x867%@\x1E\xB7\x01\xA9d;A\x1A\xE6-]\x9E\xBB9\xE9m\xC0\xB8G\xBB\x108\xB3Y|\xB7\xD5\xC8\xEF6\x0E\x16n\xB6\xE7-j;\x14\xAB\x9A\xAD\x0B\x87\xA69B\x06\x94\xB8\x93\xFA\xC078\xCE\x11\xB7\xE2\xB9o6\x177\xCE\xB5\x8Egq;\xA5\xCDn.\xF5\r\x0F:\xC2\xEES\xB9\x86<\xE68^\xF5\x90\xB8c}H8\x1D\x01\x10\xB8g\x9Dy;\xAAw\x96\xAE\xFF\x0C\xF29\x8B\xB2\x12\xB9\x15e\x828\x14X\x06\xB8,I\x977Y\xA11\xB7\xC8T\x80;J\xF4S/B\x98\xD29\x9F\xFE\xD7\xB8\xA6t\"8z\xA0\x8D\xB7\x12\x93\x067\x0F\x9F\x85\xB6\xBFm\x83;\xAC\xCA\x1D\xAF\xBA\xEB\xBA9\xDF&\xA6\xB8\x84\x9C\xD87C\xA9#\xB7\xAF\x8A\x866\xFFw\xE7\xB5\xD4{\x87;\x80\x0E\x14\xAE\xC2\x92 :\xE8\xE2m\xB9@7\x019\xDC\xB5\xA2\xB8\xCC\na8\xB2\xA3!\xB8s\x17\x8C;&\xC4]\xAE\xAE\xD8\x07:\x8D\xA9$\xB9\xFF\\\x928\xCE\xCB\x16\xB8\x06\xD0\xA97\x1BbG\xB7\0\x0C\x90;\xD7\x85y/vb\xEC9\x1Dr\xF2\xB8\xAEY68\x85\xF8\x9E\xB7\x05\x0E\x177!\xFC\x95\xB6\x12\x86\x93;\x87\xCD2/\xBE\xCF\xD19\xC6\x7F\xBA\xB8W#\xF37\x16\xB47\xB7\x9A\x04\x976M\xE8\x01\xB6H\x13\x98;\x85\x9C\xE1\xAE\xC7<4:[\x82\x85\xB94\n\x119\xE0\xA2\xB6\xB8\xEF\x99|8#o5\xB8\\?\x9D;\x9A8\xC7.\x80{\x18:\xC2\xD38\xB9\x86I\xA48NC)\xB8\xB2\x9B\xBE7\xD3\xCC_\xB7\xEA\xAF\xA1;\xD3<D\xAF\x99\xAA\x04:o\x11\x08\xB9k\xAEL8Mp\xB2\xB7\xA2\x8D)73Z\xA8\xB6\xFB\x96\xA5;\xE5\xF0U/e\x81\xEB9\x93V\xD1\xB8\xE5t\x088=3N\xB7\x0F\x83\xA96\xEF\xD0\x11\xB6\xE2\xB2\xAA;\xCE2q/EOJ:\xE8\xDB\x95\xB9>\xCD\"9\x92\0\xCD\xB8\x87\xC4\x8D8%\xA7K\xB8\x1D\x81\xB0;\x13M\xA4.\xDE'+:%vO\xB9\xFAg\xB88\xBE\xFD=\xB8Q\xF3\xD57\x065{\xB7\xDA|\xB5;J\xA1\xB5\xAE\xB9\xE9\x14:4\xBB\x18\xB9<\xBFe8gJ\xC8\xB7-Q>7\x17\xF8\xBC\xB6E\xDE\xB9;g#\x07\xAFH,\x04:c\xF9\xEA\xB8\xD9*\x198\xADsg\xB7OE\xBE6Q\xAC#\xB6W\x9A\xBF;F\x02E\xAE\xBC\x15c:\x086\xA8\xB9 \xBD69t\x1B\xE6\xB8\xFC \x9F8\xB9\x97d\xB8\x93\x1E\xC6;\xBB\x9D\x19/\xA6\x1D@:\x1F\xDEh\xB9)\xFD\xCE8\x05BU\xB8\xB9&\xF078\xFC\x8C\xB7\x8B\xB6\xCB;\x83\xDA%\xAF0&':`o+\xB9\xEF\xF0\x808\x92\xD1\xE0\xB7\xAC\x9FU7T\x1C\xD4\xB6J\xA1\xD0;\x85\x812/\xF0[\x14:\xF2\xDF\x03\xB9\xB0\xEC+8\xE1\xE5\x81\xB7Y\x92\xD56\x83\xB77\xB6%\x11\xD7;\x19!\xB7\xAD\xE9\xE4~:\x7F\xCF\xBC\xB9\n\x1EM9\xB1$\x01\xB9\xB8\x9D\xB28\x16K\x80\xB8\xADa\xDE;n\x1A\x13-\x88\xA4W:K\xB1\x82\xB9SV\xE88\xB8_o\xB8\xC5\xC7\x068%@\x9E\xB7\x01\xA9\xE4;\x9EQ\xF0\xAD\\\x9E;:\xE9m@\xB9G\xBB\x908\xB3Y\xFC\xB7\xD5\xC8o7\x0E\x16\xEE\xB6\xE7-\xEA;=\xBA\x04\xAF\n\x87&:B\x06\x14\xB9\x93\xFA@88\xCE\x91\xB7\xE2\xB9\xEF6\x177N\xB6\x8Eg\xF1;\xB6\xE8\x82-\xF5\r\x8F:\xC2\xEE\xD3\xB9\x86<f9^\xF5\x10\xB9b}\xC88\x1D\x01\x90\xB8f\x9D\xF9;\xA8\x9Ew/\xFE\x0Cr:\x8B\xB2\x92\xB9\x14e\x029\x14X\x86\xB8+I\x178X\xA1\xB1\xB7\xC8T\0<>\t\x96/A\x98R:\x9F\xFEW\xB9\xA6t\xA28z\xA0\r\xB8\x12\x93\x867\x0F\x9F\x05\xB7\xBFm\x03<nM\xE0\xAF\xBA\xEB::\xDE&&\xB9\x84\x9CX8C\xA9\xA3\xB7\xAF\x8A\x067\xFFwg\xB6\xD4{\x07<\0\xBF[\xAF\xC2\x92\xA0:\xE8\xE2\xED\xB9@7\x819\xDC\xB5\"\xB9\xCC\n\xE18\xB2\xA3\xA1\xB8s\x17\x0C<v\xFD\x87\xAF\xAD\xD8\x87:\x8D\xA9\xA4\xB9\xFF\\\x129\xCE\xCB\x96\xB8\x06\xD0)8\x1Bb\xC7\xB7\0\x0C\x10<\x11\xF5\xA1/ubl:\x1Drr\xB9\xAEY\xB68\x84\xF8\x1E\xB8\x05\x0E\x977!\xFC\x15\xB7\x12\x86\x13<\x1E|)/\xBE\xCFQ:\xC6\x7F:\xB9W#s8\x16\xB4\xB7\xB7\x9A\x04\x177M\xE8\x81\xB6H\x13\x18<\xFF\xD7\xD7\xAF\xC7<\xB4:[\x82\x05\xBA4\n\x919\xE0\xA26\xB9\xEF\x99\xFC8#o\xB5\xB8\\?\x1D<1\xD6\xE4\xAD\x7F{\x98:\xC2\xD3\xB8\xB9\x86I$9NC\xA9\xB8\xB2\x9B>8\xD3\xCC\xDF\xB7\xE9\xAF!<\x13\xED\xBF/\x97\xAA\x84:n\x11\x88\xB9j\xAE\xCC8Lp2\xB8\xA1\x8D\xA972Z(\xB7\xFB\x96%<\xC2\xD6!/d\x81k:\x92VQ\xB9\xE4t\x888=3\xCE\xB7\x0F\x83)7\xEF\xD0\x91\xB6\xE2\xB2*<\x18\xF6>/DO\xCA:\xE8\xDB\x15\xBA>\xCD\xA29\x92\0M\xB9\x87\xC4\r9%\xA7\xCB\xB8\x1D\x810<\xA1\xE4\x1D\xAF\xDD'\xAB:$v\xCF\xB9\xFAg89\xBE\xFD\xBD\xB8Q\xF3U8\x055\xFB\xB7\xD9|5<\xD1\r\xF6/\xB8\xE9\x94:3\xBB\x98\xB9;\xBF\xE58fJH\xB8,Q\xBE7\x16\xF8<\xB7D\xDE9<\xA5\xBD\xBC/F,\x84:b\xF9j\xB9\xD8*\x998\xACs\xE7\xB7NE>7P\xAC\xA3\xB6W\x9A?<\x0ET\xFF\xAF\xBB\x15\xE3:\x076(\xBA \xBD\xB69t\x1Bf\xB9\xFC \x1F9\xB9\x97\xE4\xB8\x93\x1EF<Nk\x14\xAF\xA5\x1D\xC0:\x1E\xDE\xE8\xB9)\xFDN9\x05B\xD5\xB8\xB9&p88\xFC\x0C\xB8\x8A\xB6K<\x8F\xF2D//&\xA7:^o\xAB\xB9\xEF\xF0\09\x91\xD1`\xB8\xAB\x9F\xD57S\x1CT\xB7J\xA1P<\x0B\x13/\xAF\xEF[\x94:\xF2\xDF\x83\xB9\xB0\xEC\xAB8\xE1\xE5\x01\xB8Y\x92U7\x83\xB7\xB7\xB6$\x11W<U\xAC\xC5/\xE7\xE4\xFE:}\xCF<\xBA\x08\x1E\xCD9\xB0$\x81\xB9\xB7\x9D29\x15K\0\xB9\xACa^<\xED\xFF\xC6/\x86\xA4\xD7:J\xB1\x02\xBAQVh9\xB6_\xEF\xB8\xC4\xC7\x868$@\x1E\xB8\0\xA9d<\xB4\xB2\x83/Z\x9E\xBB:\xE8m\xC0\xB9F\xBB\x109\xB1Y|\xB8\xD4\xC8\xEF7\r\x16n\xB7\xE6-j<;\xF6\xC1,\t\x87\xA6:A\x06\x94\xB9\x92\xFA\xC087\xCE\x11\xB8\xE0\xB9o7\x167\xCE\xB6\x8Dgq<1lh/\xF4\r\x0F;\xC0\xEES\xBA\x85<\xE69^\xF5\x90\xB9b}H9\x1D\x01\x10\xB9f\x9Dy<$\x08\xD0\xAF\xFC\x0C\xF2:\x8A\xB2\x12\xBA\x14e\x829\x14X\x06\xB9+I\x978X\xA11\xB8\xC8T\x80<\xF4E\xC3\xAF@\x98\xD2:\x9E\xFE\xD7\xB9\xA6t\"9z\xA0\x8D\xB8\x12\x93\x068\x0F\x9F\x85\xB7\xBEm\x83<\x0E<\xAD.\xB7\xEB\xBA:\xDD&\xA6\xB9\x82\x9C\xD88B\xA9#\xB8\xAE\x8A\x867\xFDw\xE7\xB6\xD3{\x87<\xE4a\xDD/\xC0\x92 ;\xE6\xE2m\xBA?7\x01:\xDB\xB5\xA2\xB9\xCA\na9\xB0\xA3!\xB9r\x17\x8C<\"CW/\xAB\xD8\x07;\x8B\xA9$\xBA\xFE\\\x929\xCD\xCB\x16\xB9\x05\xD0\xA98\x1AbG\xB8\0\x0C\x90<\x0FN<\xB0sb\xEC:\x1Cr\xF2\xB9\xAEY69\x84\xF8\x9E\xB8\x05\x0E\x178 \xFC\x95\xB7\x11\x86\x93<\x1D\x80\\0\xBA\xCF\xD1:\xC4\x7F\xBA\xB9T#\xF38\x14\xB47\xB8\x99\x04\x977L\xE8\x01\xB7G\x13\x98<\x11\xFE\xE7\xAF\xC4<4;Z\x82\x85\xBA3\n\x11:\xDF\xA2\xB6\xB9\xED\x99|9\"o5\xB9[?\x9D<\x14/(/}{\x18;\xC0\xD38\xBA\x85I\xA49LC)\xB9\xB1\x9B\xBE8\xD2\xCC_\xB8\xE8\xAF\xA1<\x93\x94P0\x95\xAA\x04;l\x11\x08\xBAh\xAEL9Jp\xB2\xB8\xA0\x8D)81Z\xA8\xB7\xFA\x96\xA5<\xCBTs/`\x81\xEB:\x90V\xD1\xB9\xE3t\x089<3N\xB8\r\x83\xA97\xEE\xD0\x11\xB7\xE1\xB2\xAA<\xEE\xDE\xC4.@OJ;\xE6\xDB\x95\xBA=\xCD\":\x91\0\xCD\xB9\x86\xC4\x8D9$\xA7K\xB9\x1C\x81\xB0<\xEAUS\xB0\xDA'+;\"vO\xBA\xF8g\xB89\xBD\xFD=\xB9P\xF3\xD58\x045{\xB8\xD8|\xB5<\xDC\x1Df/\xB5\xE9\x14;2\xBB\x18\xBA9\xBFe9dJ\xC8\xB8+Q>8\x15\xF8\xBC\xB7C\xDE\xB9<v\xF9N\xAFD,\x04;_\xF9\xEA\xB9\xD7*\x199\xAAsg\xB8LE\xBE7O\xAC#\xB7U\x9A\xBF<\xFE\x88^\xAF\xB5\x15c;\x056\xA8\xBA\x1D\xBD6:q\x1B\xE6\xB9\xFA \x9F9\xB7\x97d\xB9\x91\x1E\xC6<\x03\xF2\x19/\x9F\x1D@;\x1A\xDEh\xBA&\xFD\xCE9\x03BU\xB9\xB7&\xF086\xFC\x8C\xB8\x88\xB6\xCB<\x1D\xC8\x030*&';[o+\xBA\xED\xF0\x809\x8E\xD1\xE0\xB8\xA8\x9FU8P\x1C\xD4\xB7H\xA1\xD0</l\xFF\xAF\xEB[\x14;\xEF\xDF\x03\xBA\xAD\xEC+9\xDF\xE5\x81\xB8V\x92\xD57\x81\xB77\xB7\"\x11\xD7<\x03\xB7_/\xDF\xE4~;z\xCF\xBC\xBA\x05\x1EM:\xAE$\x01\xBA\xB5\x9D\xB29\x14K\x80\xB9\xAAa\xDE<\x16\x8F\x83\xAF\x7F\xA4W;H\xB1\x82\xBANV\xE89\xB4_o\xB9\xC2\xC7\x069#@\x9E\xB8\xFE\xA8\xE4<PZu\xB0T\x9E;;\xE4m@\xBAD\xBB\x909\xAEY\xFC\xB8\xD2\xC8o8\x0B\x16\xEE\xB7\xE3-\xEA<\xE4=\x08/\x02\x87&;>\x06\x14\xBA\x8E\xFA@94\xCE\x91\xB8\xDD\xB9\xEF7\x137N\xB7\x8Ag\xF1</Sf-\xEE\r\x8F;\xBC\xEE\xD3\xBA\x80<f:[\xF5\x10\xBA_}\xC89\x1B\x01\x90\xB9b\x9D\xF9<\x81\xDD\x8A.\xF1\x0Cr;\x86\xB2\x92\xBA\x11e\x02:\x11X\x86\xB9(I\x179U\xA1\xB1\xB8\xC6T\0=\xD8\xA8\0\xB06\x98R;\x99\xFEW\xBA\xA2t\xA29w\xA0\r\xB9\x10\x93\x868\r\x9F\x05\xB8\xBCm\x03=\x02+\x14\xAF\xAE\xEB:;\xD8&&\xBA}\x9CX9?\xA9\xA3\xB8\xAB\x8A\x068\xF9wg\xB7\xD1{\x07=\0px\xAF\xB8\x92\xA0;\xDF\xE2\xED\xBA<7\x81:\xD7\xB5\"\xBA\xC6\n\xE19\xAE\xA3\xA1\xB9p\x17\x0C=\x1E\xF7\xD2\xB0\xA4\xD8\x87;\x86\xA9\xA4\xBA\xFA\\\x12:\xCA\xCB\x96\xB9\x02\xD0)9\x16b\xC7\xB8\xFD\x0B\x10=Fn\xD5\xAFebl;\x13rr\xBA\xA8Y\xB69\x80\xF8\x1E\xB9\x01\x0E\x978\x1D\xFC\x15\xB8\x0E\x86\x13=/\x87\xFB0\xAE\xCFQ;\xBD\x7F:\xBAM#s9\x0F\xB4\xB7\xB8\x95\x04\x178I\xE8\x81\xB7D\x13\x18={\x9C\xE4\xB0\xB8<\xB4;U\x82\x05\xBB/\n\x91:\xDA\xA26\xBA\xE7\x99\xFC9\x1Eo\xB5\xB9X?\x1D=)\x91\xF4\xB0s{\x98;\xB9\xD3\xB8\xBA\x80I$:HC\xA9\xB9\xAC\x9B>9\xCD\xCC\xDF\xB8\xE5\xAF!=3\xCF\xEC\xB0\x8C\xAA\x84;g\x11\x88\xBAb\xAE\xCC9Fp2\xB9\x9C\x8D\xA98-Z(\xB8\xF6\x96%=z,\x1C\xAFN\x81k;\x87VQ\xBA\xDEt\x88953\xCE\xB8\x08\x83)8\xEA\xD0\x91\xB7\xDC\xB2*=\xD4\x1C\xFD0/O\xCA;\xDE\xDB\x15\xBB6\xCD\xA2:\x89\0M\xBA\x81\xC4\r:\x1D\xA7\xCB\xB9\x17\x810=\x12\xE7\xE4\xB0\xCB'\xAB;\x17v\xCF\xBA\xF0g8:\xB6\xFD\xBD\xB9I\xF3U9\xFC4\xFB\xB8\xD3|5=!\x95\xB8\xB0\xA8\xE9\x94;*\xBB\x98\xBA/\xBF\xE59]JH\xB9$Q\xBE8\x0F\xF8<\xB8=\xDE9=J\xE0\xA4.7,\x84;Q\xF9j\xBA\xD0*\x999\xA0s\xE7\xB8EE>8I\xAC\xA3\xB7N\x9A?=\xCC \xE70\x9E\x15\xE3;\xFA5(\xBB\x14\xBD\xB6:f\x1Bf\xBA\xF4 \x1F:\xAD\x97\xE4\xB9\x8A\x1EF=Y\xFE5\xAF\x8B\x1D\xC0;\x0B\xDE\xE8\xBA\x1B\xFDN:\xF9A\xD5\xB9\xAC&p91\xFC\x0C\xB9\x81\xB6K==\x02\xF7\xB0\x17&\xA7;Po\xAB\xBA\xE6\xF0\0:\x84\xD1`\xB9\x9F\x9F\xD58H\x1CT\xB8?\xA1P=C\x91\xDF0\xD9[\x94;\xE6\xDF\x83\xBA\xA3\xEC\xAB9\xD8\xE5\x01\xB9K\x92U8x\xB7\xB7\xB7\x19\x11W=\xD2\x02\xEC,\xBF\xE4\xFE;l\xCF<\xBB\xF9\x1D\xCD:\xA7$\x81\xBA\xAC\x9D2:\x0EK\0\xBA\xA0a^=b\xDCI\xB0b\xA4\xD7;=\xB1\x02\xBB>Vh:\xA6_\xEF\xB9\xBB\xC7\x869\x1B@\x1E\xB9\xF3\xA8d=x\x98\xD9\xB09\x9E\xBB;\xD3m\xC0\xBA9\xBB\x10:\x9EY|\xB9\xC4\xC8\xEF8\xFE\x15n\xB8\xD7-j=\xA1\"\x9E0\xE9\x86\xA6;0\x06\x94\xBA\x7F\xFA\xC09+\xCE\x11\xB9\xCE\xB9o8\x077\xCE\xB7}gq=\xB91\x020\xD7\r\x0F<\xA7\xEES\xBBn<\xE6:Q\xF5\x90\xBAR}H:\x12\x01\x10\xBAT\x9Dy=<IR\xB0\xC8\x0C\xF2;w\xB2\x12\xBB\x06e\x82:\x07X\x06\xBA\x1EI\x979J\xA11\xB9\xBET\x80=\x98\xB9\x890\x0F\x98\xD2;\x81\xFE\xD7\xBA\x93t\":k\xA0\x8D\xB9\x06\x93\x069\x04\x9F\x85\xB8\xB4m\x83=\x04C3\xB1\x8B\xEB\xBA;\xC5&\xA6\xBAi\x9C\xD892\xA9#\xB9\xA1\x8A\x868\xE9w\xE7\xB7\xC8{\x87=\x1C+\xAC\xB0\x98\x92 <\xC2\xE2m\xBB/7\x01;\xC9\xB5\xA2\xBA\xB5\na:\xA2\xA3!\xBAf\x17\x8C=\xA2$v\xB1\x87\xD8\x07<q\xA9$\xBB\xEB\\\x92:\xBC\xCB\x16\xBA\xF4\xCF\xA99\x07bG\xB9\xF2\x0B\x90=\xFC\x0C\xCD\xAF/b\xEC;\xF2q\xF2\xBA\x94Y6:p\xF8\x9E\xB9\xF4\r\x179\x10\xFC\x95\xB8\x03\x86\x93=\x91n\x08\xB1}\xCF\xD1;\xA3\x7F\xBA\xBA2#\xF39\xFD\xB37\xB9\x88\x04\x978>\xE8\x01\xB87\x13\x98=G''\xB1\x8A<4<@\x82\x85\xBB\x1C\n\x11;\xC6\xA2\xB6\xBA\xCE\x99|:\x0Co5\xBAI?\x9D=I\xE2\x101I{\x18<\x9A\xD38\xBBiI\xA4:3C)\xBA\x97\x9B\xBE9\xB5\xCC_\xB9\xD5\xAF\xA1=\\)\xEC/f\xAA\x04<O\x11\x08\xBBD\xAEL:/p\xB2\xB9\x88\x8D)9\x1BZ\xA8\xB8\xE5\x96\xA5=M\xEF*1\x07\x81\xEB;`V\xD1\xBA\xCAt\x08:\x1A3N\xB9\xF4\x82\xA98\xDA\xD0\x11\xB8\xCA\xB2\xAA=@\xFB\x0E1\xEFNJ<\xC2\xDB\x95\xBB\x1C\xCD\";m\0\xCD\xBAo\xC4\x8D:\x05\xA7K\xBA\x02\x81\xB0=\x12\xA8T1\x90'+<\xECuO\xBB\xD0g\xB8:\x99\xFD=\xBA+\xF3\xD59\xDB4{\xB9\xBD|\xB5=O:\x01\xB1r\xE9\x14<\x08\xBB\x18\xBB\x06\xBFe:=J\xC8\xB9\tQ>9\xF6\xF7\xBC\xB8&\xDE\xB9=\xBB\xB9}\xB1\x05,\x04<\x1C\xF9\xEA\xBA\xB3*\x19:{sg\xB9)E\xBE83\xAC#\xB85\x9A\xBF=\xAE\x15\x1E\xB1C\x15c<\xD25\xA8\xBB\xF0\xBC6;?\x1B\xE6\xBA\xDB \x9F:\x8C\x97d\xBAm\x1E\xC6=7\0t17\x1D@<\xCE\xDDh\xBB\xEF\xFC\xCE:\xD0AU\xBA\x83&\xF09\x1A\xFC\x8C\xB9b\xB6\xCB=1\x86b\xB1\xCB%'<!o+\xBB\xC9\xF0\x80:W\xD1\xE0\xB9y\x9FU9%\x1C\xD4\xB8\x1E\xA1\xD0==\x91\xB80\x92[\x14<\xC0\xDF\x03\xBBz\xEC+:\xBD\xE5\x81\xB9#\x92\xD58X\xB77\xB8\xF5\x10\xD7=\xC3\x91[\xB1>\xE4~<2\xCF\xBC\xBB\xC6\x1DM;\x8B$\x01\xBB\x89\x9D\xB2:\xF6J\x80\xBAxa\xDE=/\x15r\xB1\xED\xA3W<\x13\xB1\x82\xBB\x01V\xE8:m_o\xBA\x9F\xC7\x06:\xFC?\x9E\xB9\xC7\xA8\xE4=\xEFd\xD6\xB0\xCD\x9D;<\x91m@\xBB\x10\xBB\x90:_Y\xFC\xB9\x8D\xC8o9\xCB\x15\xEE\xB8\xA8-\xEA=k\xB9\r1\x85\x86&<\xFB\x05\x14\xBBF\xFA@:\x05\xCE\x91\xB9\x95\xB9\xEF8\xDA6N\xB8Jg\xF1=\x89\xBCI\xB1|\r\x8F<V\xEE\xD3\xBB&<f;)\xF5\x10\xBB }\xC8:\xF1\0\x90\xBA\x1B\x9D\xF9=\x14@\xA8\xB0\"\x0Cr<;\xB2\x92\xBB\xDAd\x02;\xDFW\x86\xBA\xF5H\x17:\x1D\xA1\xB1\xB9\x9FT\0>\xCC#21w\x97R<#\xFEW\xBBZt\xA2:?\xA0\r\xBA\xDF\x92\x869\xE0\x9E\x05\xB9\x92m\x03>j$\xC91\xFC\xEA:<y&&\xBB\x17\x9CX:\xFB\xA8\xA3\xB9x\x8A\x069\xA7wg\xB8\xA3{\x07>\xA2\x0F\xCD1\x15\x92\xA0<N\xE2\xED\xBB\xFC6\x81;\x90\xB5\"\xBBl\n\xE1:q\xA3\xA1\xBA=\x17\x0C>\xC9\x8Cx1\x11\xD8\x87<\x1B\xA9\xA4\xBB\xAC\\\x12;\x82\xCB\x96\xBA\xB9\xCF):\xC6a\xC7\xB9\xC6\x0B\x10>\xF1\x8B(1Wal<mqr\xBBBY\xB6:1\xF8\x1E\xBA\xBD\r\x979\xDE\xFB\x15\xB9\xD4\x85\x13>3f\x99\xB1\xB4\xCEQ<8\x7F:\xBB\xC0\"s:\xB1\xB3\xB7\xB9N\x04\x179\x11\xE8\x81\xB8\x03\x13\x18>\x13\xBB\x1A1\xD3;\xB4<\xEF\x81\x05\xBC\xD4\t\x91;u\xA26\xBBh\x99\xFC:\xC8n\xB5\xBA\x10?\x1D>\xE3\"\xA51\xA3z\x98<\"\xD3\xB8\xBB\x12I$;\xE3B\xA9\xBAE\x9B>:\\\xCC\xDF\xB9\x97\xAF!>?\x1C\n1\xCD\xA9\x84<\xF1\x10\x88\xBB\xD1\xAD\xCC:\xD6o2\xBA;\x8D\xA99\xD4Y(\xB9\xA3\x96%>6\x7F:\xB1\xEC\x7Fk<\xCAUQ\xBByt\x88:\xAF2\xCE\xB9\xA4\x82)9\x9A\xD0\x91\xB8\x81\xB2*>6\x1E\xD41\xECM\xCA<O\xDB\x15\xBC\xB6\xCC\xA2;\xFB\xFFL\xBB'\xC4\r;\xA5\xA6\xCB\xBA\xB2\x800>%\xBE\x0F\xB1\xA6&\xAB<Bu\xCF\xBBUg8;)\xFD\xBD\xBA\xB8\xF2U:]4\xFB\xB9e|5>\n\x0721\x9A\xE8\x94<\x83\xBA\x98\xBBb\xBE\xE5:\xBFIH\xBA\x9CP\xBE9\x91\xF7<\xB9\xC7\xDD9>\xCF\x92\xDE1<+\x84<E\xF8j\xBBA*\x99:\xE2r\xE7\xB9\xB6D>9\xD6\xAB\xA3\xB8\xCE\x99?>v\x1A\xB7\xB1\xD5\x13\xE3</5(\xBC`\xBC\xB6;\x9E\x1Af\xBBv \x1F;\x05\x97\xE4\xBA\xFC\x1DF>\xCB\xEC\xE5\xB1\xED\x1B\xC0<\xDE\xDC\xE8\xBB@\xFCN;2A\xD5\xBA\xE0%p:\xC1\xFB\x0C\xBA\xE6\xB5K>s?\x96\xB1\x9A$\xA7<fn\xAB\xBBV\xF0\0;\xA6\xD0`\xBA\xDF\x9E\xD59\x96\x1BT\xB9\x99\xA0P>\x15\x8A\x111vZ\x94<)\xDF\x83\xBB\xD9\xEB\xAB:Q\xE5\x01\xBA\x82\x91U9\xD7\xB6\xB7\xB8c\x10W>\xAE\xEB)\xB17\xE2\xFE<L\xCE<\xBC\xF9\x1C\xCD;\x19$\x81\xBB\xF9\x9C2;\x96J\0\xBB\xD6`^>\xC7\x87\xD01\x18\xA2\xD7<h\xB0\x02\xBC\x08Uh;\x8B^\xEF\xBA*\xC7\x86:|?\x1E\xBA\x18\xA8d>2\xB1\xBB\xB1\x1E\x9C\xBB<\x88l\xC0\xBBm\xBA\x10;dX|\xBA\xB4\xC7\xEF9\x02\x15n\xB9\xEC,j>^m\x011\xF3\x84\xA6<%\x05\x94\xBBb\xF9\xC0:m\xCD\x11\xBA\xB1\xB8o9#6\xCE\xB8{fq>w\xB2\xFD1\r\x0C\x0F=\x10\xEDS\xBC\x04;\xE6;\x88\xF4\x90\xBBT|H;i\0\x10\xBB7\x9Cy>\xDE\x1C\xFB\xAF\x8B\t\xF2<J\xB1\x12\xBC+d\x82;@W\x06\xBBRH\x97:j\xA01\xBA#T\x80>0\xE9 2\x15\x95\xD2<\xAB\xFC\xD7\xBBss\";\x8D\x9F\x8D\xBAE\x92\x06:R\x9E\x85\xB9\rm\x83>\x8C\xA102\xC5\xE8\xBA<J%\xA6\xBB\xD4\x9A\xD8:$\xA8#\xBA\xD7\x89\x869\xA5v\xE7\xB8\x12{\x87>\xB0%2\xB2\x10\x90 =\x83\xE0m\xBC06\x01<\xAD\xB4\xA2\xBBO\ta;\xB2\xA2!\xBB\x9C\x16\x8C>\xF2\x0B`1<\xD6\x07=\xC6\xA7$\xBC\xB4[\x92;\xA1\xCA\x16\xBB\xD2\xCE\xA9:\xCA`G\xBA\x17\x0B\x90>0\x04\x84\xAF\xF9]\xEC<[o\xF2\xBB\xFCW6;6\xF7\x9E\xBA\xE4\x0C\x17:\x15\xFB\x95\xB9\x18\x85\x93>\xA1Po\xB2\x91\xCB\xD1<\x8C}\xBA\xBB\xF7 \xF3:\x81\xB27\xBAj\x03\x979Z\xE7\x01\xB95\x12\x98>\xD6\xEA&0\xF684=\xA9\x80\x85\xBC\xB2\x08\x11<3\xA1\xB6\xBB\xD2\x97|;\xB9m5\xBB,>\x9D>\x15P]2\x0Cx\x18=?\xD18\xBC\xB3G\xA4;\xA5A)\xBB\xFE\x99\xBE:\xF6\xCA_\xBA\x9F\xAE\xA1>\xF5\xA6F2k\xA7\x04=z\x0F\x08\xBC\x03\xACL;sn\xB2\xBA\x07\x8C):\xB7X\xA8\xB9\x99\x95\xA5>\xE9#\x1E\xB2|{\xEB<lS\xD1\xBB7s\x08;\x001N\xBAa\x81\xA99\x97\xCF\x11\xB9^\xB1\xAA>A\x17s\xB1\xE0IJ=\x82\xD9\x95\xBC\x1D\xCB\"<5\xFE\xCC\xBB\t\xC3\x8D;&\xA5K\xBBp\x7F\xB0>h<f\xB2\xFD\"+=\x99rO\xBCfe\xB8;f\xFB=\xBB\xE9\xF0\xD5:d2{\xBA\x07{\xB5>\x16\xC5\xE1\xB1;\xE5\x14=q\xB8\x18\xBC\xD6\xBBe;\xC9G\xC8\xBA\xE9N>:\xFF\xF5\xBC\xB9O\xDC\xB9>\x85\xAF\xB30\x19(\x04=\xED\xF4\xEA\xBBx(\x19;\x81pg\xBA\xEEB\xBE9i\xAA#\xB91\x98\xBF>^\x1B\"2\x19\x0Ec=\xA32\xA8\xBC\x1C\xBA6<\x1A\x18\xE6\xBB\xDF\x1E\x9F;\xE6\x94d\xBB4\x1C\xC6>\xAF}\x1C\xB2\xBE\x16@=\x1A\xD9h\xBC\x83\xF9\xCE;\xB4>U\xBBR#\xF0:[\xFA\x8C\xBA\xF6\xB3\xCB>\x1Fl\x801\xD5\x1F'=wk+\xBC\x87\xEE\x80;\xDF\xCD\xE0\xBAv\x9CU:\\\x19\xD4\xB9\x85\x9E\xD0>\xAB\xD5\xD6\xB1\x06V\x14=\xCB\xDC\x03\xBCS\xE9+;\xA3\xE3\x81\xBA\xFC\x8E\xD59\xD2\xB47\xB9\x1C\x0E\xD7>sk1\xB2\x1D\xDA~=\xB3\xCA\xBC\xBC\xC6\x19M<R\"\x01\xBC\xBC\x9A\xB2;\x17I\x80\xBBR^\xDE>1\x901\xB2\xC4\x9AW=\xBF\xAD\x82\xBC)Q\xE8;\x06[o\xBB\\\xC5\x06;\x83=\x9E\xBA[\xA5\xE4>~8\x1F\xB2`\x95;=bh@\xBC\xE0\xB7\x90;xT\xFC\xBAM\xC4o:\xDD\x11\xEE\xB9\xFB)\xEA>.N\xAD1\xAC~&=\xCC\x01\x14\xBC\xD1\xF5@;\x0C\xCB\x91\xBA\x1F\xB5\xEF9G3N\xB9Cc\xF1>\xBBw8\xB2R\x06\x8F=\xF9\xE7\xD3\xBC\x7F6f<\x05\xF2\x10\xBC*y\xC8;K\xFE\x8F\xBB\xA7\x98\xF9>\x84:\xF1/-\xFFq=\x85\xAD\x92\xBCna\x02<\xC2T\x86\xBB\xC3E\x17;\x9E\x9D\xB1\xBA4R\0?\x16\xB0\xCF\xB2\x8C\x8BR=\xCF\xF6W\xBC\xD8o\xA2;\xC7\x9C\r\xBB\xDE\x8F\x86:\x19\x9C\x05\xBA\xF9j\x03?}='\xB2\xE4\xDF:=\x8F &\xBC\xC9\x95X;\xC7\xA4\xA3\xBAQ\x87\x06:\x9Brg\xB9\xCAx\x07?r.\x942\xF4\x87\xA0=O\xD9\xED\xBC\xFC2\x81<\x1E\xB1\"\xBC\xD3\x04\xE1;\xB3\x9F\xA1\xBB\x17\x14\x0C?\x1Ds\x0F2\xE7\xCE\x87=r\xA2\xA4\xBC\xD4W\x12<\x1C\xC7\x96\xBB4\xCB);\xD5\\\xC7\xBAZ\x08\x10?\x8F\xA4L\xB2{Pl=\x10gr\xBC\xE1R\xB6;J\xF3\x1E\xBB}\t\x97:\xF0\xF7\x15\xBA&\x82\x13?\x1B\xE6\x972\0\xBFQ=\xDAv:\xBC\xD3\x19s;\xBE\xAD\xB7\xBA\xD8\xFF\x16:}\xE4\x81\xB9\xFC\x0E\x18?\x11\xCD#\xB2~-\xB4=\x92{\x05\xBD,\x04\x91<-\x9C6\xBC}\x91\xFC;}i\xB5\xBB\x9C:\x1D?\x04e\xC01\xACm\x98=\xB6\xC9\xB8\xBC8B$<\xAA<\xA9\xBB\xE1\x94>;_\xC5\xDF\xBA\xC0\xAA!?g^\xFC\xB2\xE0\x9D\x84=\x9D\t\x88\xBC\xCC\xA4\xCC;\xE6h2\xBB8\x87\xA9:ET(\xBAo\x91%?.\xCC52\xB5ik=\xF5IQ\xBC*n\x88;E*\xCE\xBAT|):\x8C\xCB\x91\xB9\xCF\xAC*?Xa\xD8\xB2\xA69\xCA=O\xD2\x15\xBD\xB7\xC4\xA2<\x19\xF7L\xBC\x8E\xBE\r<)\x9F\xCB\xBBez0?\xD2L\x94\xB1N\x14\xAB=\xEFg\xCF\xBC\xA5]8<Z\xF4\xBD\xBB\xAC\xE9U;{*\xFB\xBA\x8Cu5?\x95\xEF\xC7\xB2\xBA\xD7\x94=%\xB0\x98\xBC\xA0\xB1\xE5;\xEF?H\xBB\x1AH\xBE:\xB4\xEF<\xBAl\xD69?g\xD8\xA0\xB2\x86\x1B\x84=\x8A\xE7j\xBCU!\x99;\xFDf\xE7\xBA\xCA;>:\xB1\xA4\xA3\xB9\xBE\x91??\xD7s\x9B\xB1$\xF7\xE2=t((\xBD\x0F\xB1\xB6<\x0C\x0Ef\xBC\x89\x18\x1F<l\x8C\xE4\xBB\x12\x15F?\n\x1BO\xB2\xF8\x01\xC0=\x06\xCA\xE8\xBC\x8C\xEEN<\xBD4\xD5\xBB\x16\x19p;\xC3\xF4\x0C\xBB5\xACK?Vx\x1F\xB1\xB9\x0C\xA7=\xBA_\xAB\xBCO\xE7\0<\xC3\xC2`\xBB\xD6\x92\xD5:v\x10T\xBA0\x96P?\x11\xDF:2:D\x94=S\xD3\x83\xBC:\xDF\xAB;\xE8\xDC\x01\xBB\xE3\x84U:\xBB\xAC\xB7\xB9\xFB\x04W?q-R2\x9D\xB9\xFE=J\xBC<\xBD\xF8\x0C\xCD<5\x1B\x81\xBC\xC5\x912<\x18C\0\xBC:T^?\xB6/m2]}\xD7=\x14\xA3\x02\xBD\xA7Ah<\xEDL\xEF\xBB\x1F\xBE\x86;\x995\x1E\xBBb\x9Ad?k\x94\x1C\xB2Sz\xBB=\xC8W\xC0\xBC\xA9\xAD\x10<\xC1D|\xBB\xAE\xB6\xEF:F\x05n\xBA2\x1Ej?g\x8D\xBB\xB2|e\xA6=g\xF4\x93\xBC\x88\xE7\xC0;\x86\xC1\x11\xBB\xD7\xA6o:\xD7'\xCE\xB9YVq?\xCCz\xDB\xB2R\xEF\x0E>\x97\xD3S\xBDb$\xE6<\xF6\xE7\x90\xBC|lH<\xD0\xF5\x0F\xBC_\x8Ay?0\x82\xAD2\x8D\xD5\xF1=o\x9E\x12\xBDvV\x82<\xCAJ\x06\xBC\x86;\x97;n\x921\xBBpJ\x80?\x08\xA4\xCA2?e\xD2=Q\xDF\xD7\xBCda\"<\xAA\x91\x8D\xBB<\x86\x06;2\x93\x85\xBA\xA2b\x83?\x8A\xCB\x12\xB3;\xBC\xBA=\x9C\r\xA6\xBC\x94\x81\xD8;O\x97#\xBB7}\x86:mb\xE7\xB9\xA7o\x87?ix5\xB2dg >y\xBCm\xBD-&\x01=\xE4\xA2\xA2\xBC\xE3\xF2`<\xB5\x93!\xBC\xFC\t\x8C?\xF2\xD4\x013o\xB1\x07>\x1A\x8D$\xBDPH\x92<\x01\xB9\x16\xBC\xB8\xBC\xA9;\x01MG\xBB]\xFD\x8F?\x98HV\xB1@\x1A\xEC=\xD4E\xF2\xBCp>6<\x91\xE3\x9E\xBB\xDD\xFB\x16;X\xEB\x95\xBAXv\x93?3V\n3\x80\x8C\xD1=\n\\\xBA\xBC=\xFD\xF2;\xB0\x9A7\xBB\x8D\xF1\x96:\x0C\xD9\x01\xBA\r\x02\x98?\x89\x19k\xB3_\xFF3>+g\x85\xBD\r\xF2\x10=\x0B\x88\xB6\xBC\x1Dx|<\x86X5\xBCN,\x9D?V\x82\xEC2\xEFC\x18>\x83\xAB8\xBDD,\xA4<\xB6()\xBCd\x80\xBE;\xFB\xAE_\xBB2\x9B\xA1?\xEB\x83M\xB3ww\x04>\x1A\xF2\x07\xBD\xE1\x87L<\xA9R\xB2\xBB\xF2s);tB\xA8\xBA\xB9\x80\xA5?M\xFD8\xB2*\"\xEB=\x04$\xD1\xBC\xF1Y\x08<P\x0FN\xBB\x1Dh\xA9:\\\xBB\x11\xBA~\x9A\xAA?act3L\xF8I>p\xB5\x95\xBD\x11\xAB\"=\x9C\xDA\xCC\xBC\x9B\xAC\x8D<'\x87K\xBC$f\xB0?\x0EuM2)\xD9*>2=O\xBD\x95>\xB8< \xD8=\xBC\xB1\xCC\xD5;\xCD\n{\xBB\x85_\xB5?\xDE\xAE\xF72J\xA1\x14>\xDF\x8E\x18\xBD\xB4\x88e<w \xC8\xBB\xD5,>;\x7F\xD6\xBC\xBA\xC1\xBE\xB9?\x85m\x183\xD2\xE8\x03>\xD7\xB1\xEA\xBC\xB7\x04\x19<\xD8@g\xBB/\x1F\xBE:\xC9\x8D#\xBA\xCFw\xBF?\xB2\x06A\xB3\x82\x9Ab>\x99\xFF\xA7\xBD\xC6\x8C6=\xBF\xE5\xE5\xBC$\xFF\x9E<xjd\xBCb\xF8\xC5?]}\x1D3\x1D\xAE?>\x88\x8Dh\xBD\x98\xC2\xCE<\xCC\x0CU\xBC\x13\xF0\xEF;Z\xDE\x8C\xBB\x02\x8D\xCB?\xB3\xE6O3\x88\xBF&>\xA20+\xBD[\xCA\x80<=\x96\xE0\xBB@lU;\xCC\xEC\xD3\xBA\xAAt\xD0?(H_0S\xFC\x13>R\xAD\x03\xBD\xBB\xB6+<\xEB\xC1\x81\xBBj\\\xD5:S\x8C7\xBA=\xE0\xD6?\xAF\xBD|296~>t\x82\xBC\xBD\x9D\xD9L=\xB1\xFE\0\xBD\xD6m\xB2<\x11+\x80\xBC\x95+\xDE?\xF9\x18\xD52e\x06W>Dx\x82\xBDq\x03\xE8<g\x14o\xBC\x1B\xA1\x06<\xE4\x15\x9E\xBB,n\xE4?~OR3\xCB\x0C;>\x1C\x15@\xBD\xAE\x84\x90<\xBE\x05\xFC\xBB\x13\x80o;\xCF\xD2\xED\xBA\xAF\xEE\xE9?\x89\xFA\xC6\xB1p\xFF%>\x9A\xBE\x13\xBD6\xAE@<U\x9B\x91\xBB\x90m\xEF:\xFB\xF9M\xBAD\"\xF1?\xE3\x85g3\x10\x92\x8E>\xB4\x81\xD3\xBD\xB0\xDBe=\x99\xBF\x10\xBD\xA09\xC8<\xD0\xD3\x8F\xBC\xC1P\xF9?\xC6\x0B\x8F\xB0\xA1,q>\xCFa\x92\xBDn*\x02=\xCA\"\x86\xBCv\x12\x17<\x8Ee\xB1\xBB\x19+\0@\0\"/3\xB0\xC9Q>\xE9\x80W\xBD`'\xA2<\x11e\r\xBC\x98_\x86;|o\x05\xBB\xF2@\x03@\xFE\x8F\xC73C+:>j\xC1%\xBDl0X<>a\xA3\xBB\xADT\x06;\x83!g\xBA\xB9J\x07@\x02\xEF\"\xB3\xE0\xE2\x9F>\x80H\xED\xBD\xB7\xF2\x80=\xC1i\"\xBD\xE7\xAA\xE0<\x95c\xA1\xBC\x1E\xE1\x0B@R\xCD\xC33`9\x87>;7\xA4\xBD\xF7\t\x12=_\x80\x96\xBC\x97\x82)<{\r\xC7\xBB\xE6\xD0\x0F@B\x9B\x932\x0F=k>\x1A\xC0q\xBDI\xEC\xB5<m\xA4\x1E\xBC(\xC5\x96;\xCA\xB8\x15\xBB\x8CF\x13@Q\x91\x98\xB3R\xBEP>\x1A\xF09\xBDQ\x8Ar<$N\xB7\xBB+\xB8\x16;\x1B\xAB\x81\xBA\xA2\xCD\x17@H`V3\xD4B\xB3>\x04\x15\x05\xBE*\xA9\x90=#76\xBD0\x12\xFC<d\x14\xB5\xBCJ\xF2\x1C@s\xB6\x9B\xB3\x0B\x99\x97>\xD81\xB8\xBD\xF7\xD3#=\x84\xD8\xA8\xBC\x16.><\x0CU\xDF\xBB\x0E\\!@\xF1\xAEG\xB3\xFB\xD9\x83>Z\x93\x87\xBD\x82\x13\xCC<=\xF91\xBC{&\xA9;\xE1\xFA'\xBB\xD5<%@\x95\xB9\xA13w\xFCi>\x0C\x8BP\xBD\x8A\x08\x88<\xE5\xA2\xCD\xBB\xD8\x16);Mz\x91\xBA",
        ),
    };
    #[inline(always)]
    fn __quick_steepness<T: __cartcontact::Scalar>(
        __a: T,
        [__j0,
        __j1,
        __j2,
        __j3,
        __j4,
        __j5,
        __j6,
        __j7,
        __j8,
        __j9,
        __j10,
        __j11,
        ]: [T; 12usize],
    ) -> __cartcontact::generated::Steepness<T> {
        let __s = __a * __a;
        let __value = (__j0 + (__j1) * __s)
            + ((__j2 + (__j3) * __s)
                + ((__j4 + (__j5) * __s)
                    + ((__j6 + (__j7) * __s)
                        + ((__j8 + (__j9) * __s) + (__j10 + (__j11) * __s) * (__s * __s))
                            * (__s * __s)) * (__s * __s)) * (__s * __s)) * (__s * __s);
        __cartcontact::generated::Steepness {
            power: __cartcontact::generated::integer_power(__s, 3),
            value: __value,
            excess: <T as __cartcontact::Scalar>::constant(0.0f64),
            first: <T as __cartcontact::Scalar>::constant(6.0f64) * __j0
                + (<T as __cartcontact::Scalar>::constant(8.0f64) * __j1
                    + (<T as __cartcontact::Scalar>::constant(10.0f64) * __j2
                        + (<T as __cartcontact::Scalar>::constant(12.0f64) * __j3
                            + (<T as __cartcontact::Scalar>::constant(14.0f64) * __j4
                                + (<T as __cartcontact::Scalar>::constant(16.0f64) * __j5
                                    + (<T as __cartcontact::Scalar>::constant(18.0f64) * __j6
                                        + (<T as __cartcontact::Scalar>::constant(20.0f64) * __j7
                                            + (<T as __cartcontact::Scalar>::constant(22.0f64) * __j8
                                                + (<T as __cartcontact::Scalar>::constant(24.0f64) * __j9
                                                    + (<T as __cartcontact::Scalar>::constant(26.0f64) * __j10
                                                        + (<T as __cartcontact::Scalar>::constant(28.0f64) * __j11)
                                                            * __s) * __s) * __s) * __s) * __s) * __s) * __s) * __s)
                            * __s) * __s) * __s,
            half_second: <T as __cartcontact::Scalar>::constant(15.0f64) * __j0
                + (<T as __cartcontact::Scalar>::constant(28.0f64) * __j1
                    + (<T as __cartcontact::Scalar>::constant(45.0f64) * __j2
                        + (<T as __cartcontact::Scalar>::constant(66.0f64) * __j3
                            + (<T as __cartcontact::Scalar>::constant(91.0f64) * __j4
                                + (<T as __cartcontact::Scalar>::constant(120.0f64) * __j5
                                    + (<T as __cartcontact::Scalar>::constant(153.0f64) * __j6
                                        + (<T as __cartcontact::Scalar>::constant(190.0f64) * __j7
                                            + (<T as __cartcontact::Scalar>::constant(231.0f64) * __j8
                                                + (<T as __cartcontact::Scalar>::constant(276.0f64) * __j9
                                                    + (<T as __cartcontact::Scalar>::constant(325.0f64) * __j10
                                                        + (<T as __cartcontact::Scalar>::constant(378.0f64) * __j11)
                                                            * __s) * __s) * __s) * __s) * __s) * __s) * __s) * __s)
                            * __s) * __s) * __s,
            per_unit: <T as __cartcontact::Scalar>::constant(1.0f64),
        }
    }
    #[inline(always)]
    fn __last_steepness<T: __cartcontact::Scalar>(
        __a: T,
        [__j0,
        __j1,
        __j2,
        __j3,
        __j4,
        __j5,
        __j6,
        __j7,
        __j8,
        __j9,
        __j10,
        __j11,
        ]: [T; 12usize],
    ) -> __cartcontact::generated::Steepness<T> {
        let __s = __a * __a;
        let __value = __j0
            + (__j1
                + (__j2
                    + (__j3
                        + (__j4
                            + (__j5
                                + (__j6
                                    + (__j7
                                        + (__j8 + (__j9 + (__j10 + (__j11) * __s) * __s) * __s)
                                            * __s) * __s) * __s) * __s) * __s) * __s) * __s) * __s;
        __cartcontact::generated::Steepness {
            power: __cartcontact::generated::integer_power(__s, 3),
            value: __value,
            excess: <T as __cartcontact::Scalar>::constant(0.0f64),
            first: <T as __cartcontact::Scalar>::constant(6.0f64) * __j0
                + (<T as __cartcontact::Scalar>::constant(8.0f64) * __j1
                    + (<T as __cartcontact::Scalar>::constant(10.0f64) * __j2
                        + (<T as __cartcontact::Scalar>::constant(12.0f64) * __j3
                            + (<T as __cartcontact::Scalar>::constant(14.0f64) * __j4
                                + (<T as __cartcontact::Scalar>::constant(16.0f64) * __j5
                                    + (<T as __cartcontact::Scalar>::constant(18.0f64) * __j6
                                        + (<T as __cartcontact::Scalar>::constant(20.0f64) * __j7
                                            + (<T as __cartcontact::Scalar>::constant(22.0f64) * __j8
                                                + (<T as __cartcontact::Scalar>::constant(24.0f64) * __j9
                                                    + (<T as __cartcontact::Scalar>::constant(26.0f64) * __j10
                                                        + (<T as __cartcontact::Scalar>::constant(28.0f64) * __j11)
                                                            * __s) * __s) * __s) * __s) * __s) * __s) * __s) * __s)
                            * __s) * __s) * __s,
            half_second: <T as __cartcontact::Scalar>::constant(15.0f64) * __j0
                + (<T as __cartcontact::Scalar>::constant(28.0f64) * __j1
                    + (<T as __cartcontact::Scalar>::constant(45.0f64) * __j2
                        + (<T as __cartcontact::Scalar>::constant(66.0f64) * __j3
                            + (<T as __cartcontact::Scalar>::constant(91.0f64) * __j4
                                + (<T as __cartcontact::Scalar>::constant(120.0f64) * __j5
                                    + (<T as __cartcontact::Scalar>::constant(153.0f64) * __j6
                                        + (<T as __cartcontact::Scalar>::constant(190.0f64) * __j7
                                            + (<T as __cartcontact::Scalar>::constant(231.0f64) * __j8
                                                + (<T as __cartcontact::Scalar>::constant(276.0f64) * __j9
                                                    + (<T as __cartcontact::Scalar>::constant(325.0f64) * __j10
                                                        + (<T as __cartcontact::Scalar>::constant(378.0f64) * __j11)
                                                            * __s) * __s) * __s) * __s) * __s) * __s) * __s) * __s)
                            * __s) * __s) * __s,
            per_unit: <T as __cartcontact::Scalar>::constant(1.0f64),
        }
    }
    #[automatically_derived]
    impl<T> __cartcontact::GapProfile<T> for Spheres
    where
        T: __cartcontact::Scalar,
    {
        #[inline]
        fn gap(&self, __r: T) -> T {
            __cartcontact::generated::in_double_words!(
                __FUSED => { __cartcontact::generated::precise_even_sum:: < _, _,
                __FUSED, _ > (__r, 2u32, __cartcontact::generated::constants:: < T, _ >
                ([0.075, 0.000140625, 6.4453125e-7, 3.936767578125e-9,
                2.739715576171875e-11, 2.0517826080322267e-13, 1.6115248203277588e-15,
                1.309244055300951e-17, 1.0910117416642606e-19, 9.273546740587335e-22,
                8.00896072814794e-24, 7.007838130931532e-26])) }
            )
        }
        #[inline]
        fn approach(&self, __a: T) -> T {
            __cartcontact::generated::in_double_words!(
                __FUSED => { __cartcontact::generated::precise_even_sum:: < _, _,
                __FUSED, _ > (__a, 2u32, __cartcontact::generated::constants:: < T, _ >
                ([0.0375, 4.6875e-5, 1.611328125e-7, 7.87353515625e-10,
                4.566192626953125e-12, 2.931118011474609e-14, 2.0144060254096985e-16,
                1.4547156170010567e-18, 1.0910117416642607e-20, 8.430497036897578e-23,
                6.674133940123284e-25, 5.390644716101178e-27])) }
            )
        }
        #[inline]
        fn approach_slope(&self, __a: T) -> T {
            __cartcontact::generated::in_double_words!(
                __FUSED => { __cartcontact::generated::precise_even_sum:: < _, _,
                __FUSED, _ > (__a, 1u32, __cartcontact::generated::constants:: < T, _ >
                ([0.075, 0.0001875, 9.66796875e-7, 6.298828125e-9, 4.566192626953125e-11,
                3.517341613769531e-13, 2.8201684355735777e-15, 2.3275449872016907e-17,
                1.9638211349956691e-19, 1.6860994073795155e-21, 1.4683094668271224e-23,
                1.2937547318642829e-25])) }
            )
        }
        #[inline]
        fn load_integral(&self, __a: T) -> T {
            __cartcontact::generated::in_double_words!(
                __FUSED => { __cartcontact::generated::power_sum:: < _, _, _, __FUSED >
                (__a, __cartcontact::generated::whole_terms(& [(0.00625, 6),
                (1.171875e-5, 8), (4.833984375e-8, 10), (2.62451171875e-10, 12),
                (1.6307830810546874e-12, 14), (1.0991692543029785e-14, 16),
                (7.833801209926605e-17, 18), (5.818862468004227e-19, 20),
                (4.4632298522628844e-21, 22), (3.512707098707324e-23, 24),
                (2.82367205159062e-25, 26), (2.310276306900505e-27, 28)])) }
            )
        }
        #[inline]
        fn log_kernel(&self, __x: T) -> T {
            __cartcontact::generated::in_double_words!(
                __FUSED => { __cartcontact::generated::power_sum:: < _, _, _, __FUSED >
                (__x, __cartcontact::generated::whole_terms(& [(0.0046875, 4),
                (3.90625e-6, 6), (1.007080078125e-8, 8), (3.936767578125e-11, 10),
                (1.9025802612304688e-13, 12), (1.046827861240932e-15, 14),
                (6.295018829405308e-18, 16), (4.040876713891824e-20, 18),
                (2.7275293541606515e-22, 20), (1.9160220538403586e-24, 22),
                (1.3904445708590175e-26, 24), (1.0366624454040728e-28, 26)])) }
            )
        }
        #[inline]
        fn quick_approach(&self, __a: T) -> T {
            __cartcontact::generated::quick_even_sum(
                __a,
                2u32,
                __cartcontact::generated::constants::<
                    T,
                    _,
                >([
                    0.0375,
                    4.6875e-5,
                    1.611328125e-7,
                    7.87353515625e-10,
                    4.566192626953125e-12,
                    2.931118011474609e-14,
                    2.0144060254096985e-16,
                    1.4547156170010567e-18,
                    1.0910117416642607e-20,
                    8.430497036897578e-23,
                    6.674133940123284e-25,
                    5.390644716101178e-27,
                ]),
            )
        }
        #[inline]
        fn quick_approach_slope(&self, __a: T) -> T {
            __cartcontact::generated::quick_even_sum(
                __a,
                1u32,
                __cartcontact::generated::constants::<
                    T,
                    _,
                >([
                    0.075,
                    0.0001875,
                    9.66796875e-7,
                    6.298828125e-9,
                    4.566192626953125e-11,
                    3.517341613769531e-13,
                    2.8201684355735777e-15,
                    2.3275449872016907e-17,
                    1.9638211349956691e-19,
                    1.6860994073795155e-21,
                    1.4683094668271224e-23,
                    1.2937547318642829e-25,
                ]),
            )
        }
        #[inline]
        fn quick_load_integral(&self, __a: T) -> T {
            __cartcontact::generated::quick_even_sum(
                __a,
                6u32,
                __cartcontact::generated::constants::<
                    T,
                    _,
                >([
                    0.00625,
                    1.171875e-5,
                    4.833984375e-8,
                    2.62451171875e-10,
                    1.6307830810546874e-12,
                    1.0991692543029785e-14,
                    7.833801209926605e-17,
                    5.818862468004227e-19,
                    4.4632298522628844e-21,
                    3.512707098707324e-23,
                    2.82367205159062e-25,
                    2.310276306900505e-27,
                ]),
            )
        }
        #[inline]
        fn pressure_kernel(&self, __a: T, __r: T) -> T {
            __cartcontact::generated::in_double_words!(
                __FUSED => { __cartcontact::generated::pressure_kernel:: < _, _, _,
                __FUSED > (__a, __r, __cartcontact::generated::whole_terms(& [(0.075, 2),
                (0.000140625, 4), (6.4453125e-7, 6), (3.936767578125e-9, 8),
                (2.739715576171875e-11, 10), (2.0517826080322267e-13, 12),
                (1.6115248203277588e-15, 14), (1.309244055300951e-17, 16),
                (1.0910117416642606e-19, 18), (9.273546740587335e-22, 20),
                (8.00896072814794e-24, 22), (7.007838130931532e-26, 24)])) }
            )
        }
        #[inline(always)]
        fn quick_pressure_kernel(&self, __a: T, __r: T) -> T {
            __cartcontact::generated::quick_even_pressure_kernel(
                __a,
                __r,
                __cartcontact::generated::constants::<
                    T,
                    _,
                >([
                    0.0046875,
                    3.90625e-6,
                    1.007080078125e-8,
                    3.936767578125e-11,
                    1.9025802612304688e-13,
                    1.046827861240932e-15,
                    6.295018829405308e-18,
                    4.040876713891824e-20,
                    2.7275293541606515e-22,
                    1.9160220538403586e-24,
                    1.3904445708590175e-26,
                    1.0366624454040728e-28,
                ]),
            )
        }
        #[inline(always)]
        fn radius_within(
            &self,
            __load_integral: T,
            __limit: T,
        ) -> ::core::result::Result<T, __cartcontact::RadiusError> {
            match __cartcontact::generated::Curves::radius(
                __cartcontact::generated::Curves {
                    double: &__CURVES,
                    single: &__CURVES_OF_SINGLE,
                },
                __load_integral,
                __limit,
            ) {
                ::core::option::Option::Some(__a) => ::core::result::Result::Ok(__a),
                ::core::option::Option::None => {
                    __cartcontact::generated::out_of_line(move || {
                        match __cartcontact::generated::WholePowers::radius(
                            &__cartcontact::generated::WholePowers::<
                                _,
                                _,
                                _,
                                12usize,
                                1,
                            > {
                                coefficients: [
                                    <T as __cartcontact::Scalar>::constant(0.00625f64),
                                    <T as __cartcontact::Scalar>::constant(1.171875e-5f64),
                                    <T as __cartcontact::Scalar>::constant(4.833984375e-8f64),
                                    <T as __cartcontact::Scalar>::constant(
                                        2.62451171875e-10f64,
                                    ),
                                    <T as __cartcontact::Scalar>::constant(
                                        1.6307830810546874e-12f64,
                                    ),
                                    <T as __cartcontact::Scalar>::constant(
                                        1.0991692543029785e-14f64,
                                    ),
                                    <T as __cartcontact::Scalar>::constant(
                                        7.833801209926605e-17f64,
                                    ),
                                    <T as __cartcontact::Scalar>::constant(
                                        5.818862468004227e-19f64,
                                    ),
                                    <T as __cartcontact::Scalar>::constant(
                                        4.4632298522628844e-21f64,
                                    ),
                                    <T as __cartcontact::Scalar>::constant(
                                        3.512707098707324e-23f64,
                                    ),
                                    <T as __cartcontact::Scalar>::constant(
                                        2.82367205159062e-25f64,
                                    ),
                                    <T as __cartcontact::Scalar>::constant(
                                        2.310276306900505e-27f64,
                                    ),
                                ],
                                powers: [6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28],
                                steepness: __quick_steepness,
                                last_steepness: __last_steepness,
                                per_unit: <T as __cartcontact::Scalar>::constant(1.0f64),
                            },
                            __load_integral,
                            __limit,
                        ) {
                            ::core::option::Option::Some(__a) => {
                                ::core::result::Result::Ok(__a)
                            }
                            ::core::option::Option::None => {
                                __cartcontact::generated::out_of_line(move || {
                                    __cartcontact::generated::invert(
                                        __load_integral,
                                        __limit,
                                        ::core::iter::IntoIterator::into_iter([
                                            __cartcontact::generated::PositiveTerm::of(
                                                <T as __cartcontact::Scalar>::constant(0.075f64),
                                                <T as __cartcontact::Scalar>::constant(2.0f64),
                                            ),
                                            __cartcontact::generated::PositiveTerm::of(
                                                <T as __cartcontact::Scalar>::constant(0.000140625f64),
                                                <T as __cartcontact::Scalar>::constant(4.0f64),
                                            ),
                                            __cartcontact::generated::PositiveTerm::of(
                                                <T as __cartcontact::Scalar>::constant(6.4453125e-7f64),
                                                <T as __cartcontact::Scalar>::constant(6.0f64),
                                            ),
                                            __cartcontact::generated::PositiveTerm::of(
                                                <T as __cartcontact::Scalar>::constant(
                                                    3.936767578125e-9f64,
                                                ),
                                                <T as __cartcontact::Scalar>::constant(8.0f64),
                                            ),
                                            __cartcontact::generated::PositiveTerm::of(
                                                <T as __cartcontact::Scalar>::constant(
                                                    2.739715576171875e-11f64,
                                                ),
                                                <T as __cartcontact::Scalar>::constant(10.0f64),
                                            ),
                                            __cartcontact::generated::PositiveTerm::of(
                                                <T as __cartcontact::Scalar>::constant(
                                                    2.0517826080322267e-13f64,
                                                ),
                                                <T as __cartcontact::Scalar>::constant(12.0f64),
                                            ),
                                            __cartcontact::generated::PositiveTerm::of(
                                                <T as __cartcontact::Scalar>::constant(
                                                    1.6115248203277588e-15f64,
                                                ),
                                                <T as __cartcontact::Scalar>::constant(14.0f64),
                                            ),
                                            __cartcontact::generated::PositiveTerm::of(
                                                <T as __cartcontact::Scalar>::constant(
                                                    1.309244055300951e-17f64,
                                                ),
                                                <T as __cartcontact::Scalar>::constant(16.0f64),
                                            ),
                                            __cartcontact::generated::PositiveTerm::of(
                                                <T as __cartcontact::Scalar>::constant(
                                                    1.0910117416642606e-19f64,
                                                ),
                                                <T as __cartcontact::Scalar>::constant(18.0f64),
                                            ),
                                            __cartcontact::generated::PositiveTerm::of(
                                                <T as __cartcontact::Scalar>::constant(
                                                    9.273546740587335e-22f64,
                                                ),
                                                <T as __cartcontact::Scalar>::constant(20.0f64),
                                            ),
                                            __cartcontact::generated::PositiveTerm::of(
                                                <T as __cartcontact::Scalar>::constant(
                                                    8.00896072814794e-24f64,
                                                ),
                                                <T as __cartcontact::Scalar>::constant(22.0f64),
                                            ),
                                            __cartcontact::generated::PositiveTerm::of(
                                                <T as __cartcontact::Scalar>::constant(
                                                    7.007838130931532e-26f64,
                                                ),
                                                <T as __cartcontact::Scalar>::constant(24.0f64),
                                            ),
                                        ]),
                                        false,
                                        |__a| {
                                            let __x = __a * __a;
                                            let (__value, __slope) = __cartcontact::generated::value_and_slope(
                                                __x,
                                                __cartcontact::generated::constants::<
                                                    T,
                                                    _,
                                                >([
                                                    0.00625,
                                                    1.171875e-5,
                                                    4.833984375e-8,
                                                    2.62451171875e-10,
                                                    1.6307830810546874e-12,
                                                    1.0991692543029785e-14,
                                                    7.833801209926605e-17,
                                                    5.818862468004227e-19,
                                                    4.4632298522628844e-21,
                                                    3.512707098707324e-23,
                                                    2.82367205159062e-25,
                                                    2.310276306900505e-27,
                                                ]),
                                            );
                                            let __log_slope = <T as __cartcontact::Scalar>::constant(
                                                6.0f64,
                                            ) * __value
                                                + <T as __cartcontact::Scalar>::constant(2.0f64) * __x
                                                    * __slope;
                                            (__value * __x * __x * __x, __log_slope * __x * __x * __x)
                                        },
                                        |__a| {
                                            __cartcontact::generated::in_double_words!(
                                                __FUSED => { __cartcontact::generated::power_sum:: < _, _,
                                                _, __FUSED > (__a, __cartcontact::generated::whole_terms(&
                                                [(0.00625, 6), (1.171875e-5, 8), (4.833984375e-8, 10),
                                                (2.62451171875e-10, 12), (1.6307830810546874e-12, 14),
                                                (1.0991692543029785e-14, 16), (7.833801209926605e-17, 18),
                                                (5.818862468004227e-19, 20), (4.4632298522628844e-21, 22),
                                                (3.512707098707324e-23, 24), (2.82367205159062e-25, 26),
                                                (2.310276306900505e-27, 28)])) }
                                            )
                                        },
                                    )
                                })
                            }
                        }
                    })
                }
            }
        }
        fn radii_within(
            &self,
            __load_integrals: &[T],
            __limit: T,
            __radii: &mut [T],
        ) -> ::core::result::Result<(), __cartcontact::RadiusError> {
            __cartcontact::generated::Curves::radii_also_outside(
                __cartcontact::generated::Curves {
                    double: &__CURVES,
                    single: &__CURVES_OF_SINGLE,
                },
                (__load_integrals, __radii),
                __limit,
                #[inline(always)]
                |__load_integral, __more| __cartcontact::generated::WholePowers::solve(
                    &__cartcontact::generated::WholePowers::<_, _, _, 12usize, 1> {
                        coefficients: [
                            <T as __cartcontact::Scalar>::constant(0.00625f64),
                            <T as __cartcontact::Scalar>::constant(1.171875e-5f64),
                            <T as __cartcontact::Scalar>::constant(4.833984375e-8f64),
                            <T as __cartcontact::Scalar>::constant(2.62451171875e-10f64),
                            <T as __cartcontact::Scalar>::constant(
                                1.6307830810546874e-12f64,
                            ),
                            <T as __cartcontact::Scalar>::constant(
                                1.0991692543029785e-14f64,
                            ),
                            <T as __cartcontact::Scalar>::constant(
                                7.833801209926605e-17f64,
                            ),
                            <T as __cartcontact::Scalar>::constant(
                                5.818862468004227e-19f64,
                            ),
                            <T as __cartcontact::Scalar>::constant(
                                4.4632298522628844e-21f64,
                            ),
                            <T as __cartcontact::Scalar>::constant(
                                3.512707098707324e-23f64,
                            ),
                            <T as __cartcontact::Scalar>::constant(
                                2.82367205159062e-25f64,
                            ),
                            <T as __cartcontact::Scalar>::constant(
                                2.310276306900505e-27f64,
                            ),
                        ],
                        powers: [6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28],
                        steepness: __quick_steepness,
                        last_steepness: __last_steepness,
                        per_unit: <T as __cartcontact::Scalar>::constant(1.0f64),
                    },
                    __load_integral,
                    __more,
                ),
                |__load_integral| __cartcontact::GapProfile::radius_within(
                    self,
                    __load_integral,
                    __limit,
                ),
            )
        }
        #[inline]
        fn has_quick_radii(&self) -> ::core::primitive::bool {
            true
        }
        #[inline]
        fn load_integral_drop(&self, __a: T, __depth: T) -> T {
            let __s = __a - __depth;
            __depth
                * ((__a + __s)
                    * __cartcontact::generated::divided_difference(
                        __a * __a,
                        __s * __s,
                        __cartcontact::generated::constants::<
                            T,
                            _,
                        >([
                            0.0,
                            0.0,
                            0.0,
                            0.00625,
                            1.171875e-5,
                            4.833984375e-8,
                            2.62451171875e-10,
                            1.6307830810546874e-12,
                            1.0991692543029785e-14,
                            7.833801209926605e-17,
                            5.818862468004227e-19,
                            4.4632298522628844e-21,
                            3.512707098707324e-23,
                            2.82367205159062e-25,
                            2.310276306900505e-27,
                        ]),
                    ))
        }
        #[inline]
        fn fill_slopes_and_drops(
            &self,
            __a: T,
            __places: (&[T], &[T]),
            __values: (&mut [T], &mut [T]),
        ) {
            __cartcontact::generated::fill_by_functions(
                self,
                __a,
                __places,
                __values,
                #[inline(always)]
                |__r| {
                    __cartcontact::generated::quick_even_sum(
                        __r,
                        1u32,
                        __cartcontact::generated::constants::<
                            T,
                            _,
                        >([
                            0.075,
                            0.0001875,
                            9.66796875e-7,
                            6.298828125e-9,
                            4.566192626953125e-11,
                            3.517341613769531e-13,
                            2.8201684355735777e-15,
                            2.3275449872016907e-17,
                            1.9638211349956691e-19,
                            1.6860994073795155e-21,
                            1.4683094668271224e-23,
                            1.2937547318642829e-25,
                        ]),
                    )
                },
                #[inline(always)]
                |__depth| {
                    let __s = __a - __depth;
                    __depth
                        * ((__a + __s)
                            * __cartcontact::generated::divided_difference(
                                __a * __a,
                                __s * __s,
                                __cartcontact::generated::constants::<
                                    T,
                                    _,
                                >([
                                    0.0,
                                    0.0,
                                    0.0,
                                    0.00625,
                                    1.171875e-5,
                                    4.833984375e-8,
                                    2.62451171875e-10,
                                    1.6307830810546874e-12,
                                    1.0991692543029785e-14,
                                    7.833801209926605e-17,
                                    5.818862468004227e-19,
                                    4.4632298522628844e-21,
                                    3.512707098707324e-23,
                                    2.82367205159062e-25,
                                    2.310276306900505e-27,
                                ]),
                            ))
                },
            )
        }
        #[inline]
        fn max_radius(&self) -> T {
            <T as __cartcontact::Scalar>::constant(5.0f64)
        }
        #[inline]
        fn highest_exponent(&self) -> T {
            <T as __cartcontact::Scalar>::constant(24.0f64)
        }
        #[inline]
        fn is_smooth_at_centre(&self) -> ::core::primitive::bool {
            true
        }
        #[inline]
        fn has_only_positive_terms(&self) -> ::core::primitive::bool {
            true
        }
    }
    #[allow(unreachable_pub, reason = "a program need not ask for them")]
    impl Spheres {
        /// The terms of the gap Σ C rⁿ as pairs (C, n), in ascending order of their exponents.
        pub const TERMS: [(::core::primitive::f64, ::core::primitive::f64); 12usize] = [
            (0.075f64, 2.0f64),
            (0.000140625f64, 4.0f64),
            (6.4453125e-7f64, 6.0f64),
            (3.936767578125e-9f64, 8.0f64),
            (2.739715576171875e-11f64, 10.0f64),
            (2.0517826080322267e-13f64, 12.0f64),
            (1.6115248203277588e-15f64, 14.0f64),
            (1.309244055300951e-17f64, 16.0f64),
            (1.0910117416642606e-19f64, 18.0f64),
            (9.273546740587335e-22f64, 20.0f64),
            (8.00896072814794e-24f64, 22.0f64),
            (7.007838130931532e-26f64, 24.0f64),
        ];
        /// The largest contact radius that the geometry is proved for, in mm; infinity if there is no limit.
        pub const MAX_RADIUS: ::core::primitive::f64 = 5.0f64;
        /// How much of the exact gap the expansion of its surfaces neglects, at most, up to `MAX_RADIUS`.
        pub const TRUNCATION_ERROR: ::core::primitive::f64 = 6.06e-10f64;
    }
};
