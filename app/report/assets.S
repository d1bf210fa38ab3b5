/* Puts the report's text files into the library; the include path finds them, Plotly has a path of its own. */
.macro embed name, file
    .global swayaw_report_\name
    .global swayaw_report_\name\()_end
swayaw_report_\name:
    .incbin "\file"
swayaw_report_\name\()_end:
.endm

    .section .rodata
    embed page_html, page.html
    embed scripts_html, scripts.html
    embed page_css, page.css
    embed page_js, page.js
    embed check_js, check.js
    embed compare_js, compare.js
    embed loop_js, loop.js
    embed diagnose_js, diagnose.js
    embed trial_js, trial.js
    embed plotly_js, SWAYAW_PLOTLY

    .section .note.GNU-stack, "", %progbits
