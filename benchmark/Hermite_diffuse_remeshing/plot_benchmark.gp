# Draws a table of hermite_diffuse_remesh_benchmark: gnuplot -e "table='X.csv'; plot_file='X.svg'" plot_benchmark.gp
# Above: thousands of faces per second over the number of faces. Below: the share of the stages in the time.
set datafile separator ","
set terminal svg size 900,900 font "sans,12" background "white"
set output plot_file
set multiplot layout 2,1

methods = system("tail -n +2 '".table."' | cut -d, -f3,4 | sort -u | tr ' ' '_' | tr '\n' ' '")
label_of(m) = system("echo '".m."' | tr '_' ' ' | sed 's/,1$//; s/,2$/, two threads/'")
rows_of(m) = "< awk -F, -v OFS=, -v m='".m."' 'NR > 1 { n = $3; gsub(\" \", \"_\", n); if(n \",\" $4 == m) print }' '".table."'"
set logscale x
set xlabel "faces of the result"
set ylabel "thousands of faces per second"
set yrange [0:*]
set key outside right top
set grid
plot for [m in methods] rows_of(m) using 6:($8 / 1000) with points pointtype 7 pointsize 1 title label_of(m)

unset logscale
unset xlabel
set style data histograms
set style histogram rowstacked
set style fill solid 0.7
set boxwidth 0.8
set xtics rotate by -40 font "sans,8"
set ylabel "seconds per million faces"
stages = "< awk -F, 'NR == 1 || $11 > 0' '".table."'"
plot for [c=9:14] stages using (column(c) / column(6) * 1e6):xtic(sprintf("%s %s %s", strcol(2), strcol(6), strcol(3) eq "this package" ? (strcol(4) eq "2" ? "(2)" : "") : strcol(3))) \
  title columnheader(c)
unset multiplot
