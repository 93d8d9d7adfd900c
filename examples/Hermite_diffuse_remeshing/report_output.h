// What remesh_file tells about a run: progress on a terminal, a table, and JSON.

#ifndef HERMITE_DIFFUSE_REMESHING_EXAMPLES_REPORT_OUTPUT_H
#define HERMITE_DIFFUSE_REMESHING_EXAMPLES_REPORT_OUTPUT_H

#include <CGAL/Hermite_diffuse_remeshing/Default_remeshing_visitor.h>
#include <CGAL/Hermite_diffuse_remeshing/Remeshing_report.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <string>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

inline bool is_terminal()
{
#ifdef _WIN32
  return _isatty(_fileno(stderr)) != 0;
#else
  return isatty(STDERR_FILENO) != 0;
#endif
}

// one line per stage on the terminal, rewritten as the stage advances
template <typename Mesh>
class Progress_line
  : public CGAL::Hermite_diffuse_remeshing::Default_remeshing_visitor<Mesh>
{
  std::ostream& os;
  const bool is_shown;
  bool is_open = false;
  std::string stage;
  int percent = 0;

  void show()
  {
    if(is_shown)
      os << "\r" << std::left << std::setw(28) << stage << std::right << std::setw(4) << percent
         << " %" << std::flush;
  }

public:
  Progress_line(std::ostream& os, const bool is_shown) : os(os), is_shown(is_shown) {}

  // an error that follows starts on a line of its own
  ~Progress_line()
  {
    if(is_shown && is_open)
      os << "\n";
  }

  Progress_line(const Progress_line&) = delete;
  Progress_line& operator=(const Progress_line&) = delete;

  void stage_begins(const char* name)
  {
    stage = name;
    percent = 0;
    is_open = true;
    show();
  }

  void progress(const double fraction)
  {
    const int now = static_cast<int>(100. * fraction);
    if(now == percent)
      return;
    percent = now;
    show();
  }

  void stage_ends(const char*)
  {
    percent = 100;
    show();
    if(is_shown)
      os << "\n";
    is_open = false;
  }
};

// why the quality of a face is low, as a sentence without its end
template <typename Face>
std::string explanation(const CGAL::Hermite_diffuse_remeshing::Low_quality_face<Face>& low)
{
  using namespace CGAL::Hermite_diffuse_remeshing;
  std::ostringstream text;
  text.precision(3);
  switch(low.obstacle)
  {
    case QUALITY_AT_FEATURE_ANGLE:
      text << "two features meet at " << low.angle << " degrees, where no triangle is better than " << low.best_quality;
      break;
    case QUALITY_AT_PROTECTED_EDGE:
      text << "one of its edges may not be changed";
      break;
    case QUALITY_AT_CLOSE_CORNERS:
      text << "two corners are " << low.distance << " apart, the size is " << low.size;
      break;
    case QUALITY_BETWEEN_FEATURES:
      text << "the features at its sides are " << low.distance << " apart, the size is " << low.size;
      break;
    case QUALITY_AT_FOLD:
      text << "the model is folded there";
      break;
    case QUALITY_AT_INTERSECTION:
      text << "a better one would intersect others";
      break;
    case QUALITY_AT_OTHER_FACES:
      text << "a better one makes one beside it worse";
      break;
    case QUALITY_AFTER_STOP:
      text << "the remeshing ended before";
      break;
  }
  return text.str();
}

// number of faces per reason, as members of a JSON object
template <typename Obstacle, typename Count>
std::string counts(const std::initializer_list<Obstacle> obstacles, const Count& count)
{
  std::string result;
  for(const Obstacle obstacle : obstacles)
    result += std::string(result.empty() ? "" : ", ") + "\"" + CGAL::Hermite_diffuse_remeshing::name(obstacle) + "\": "
            + std::to_string(count(obstacle));
  return result;
}

template <typename Mesh>
void write_json(std::ostream& os,
                const CGAL::Hermite_diffuse_remeshing::Remeshing_report<Mesh>& r)
{
  // JSON has no infinity
  const auto number = [](const double value)
  {
    std::ostringstream text;
    text.precision(17);
    text << value;
    return std::isfinite(value) ? text.str() : std::string("null");
  };
  const auto& worst = r.point_of_largest_deviation;
  using namespace CGAL::Hermite_diffuse_remeshing;
  const std::string deviation_obstacles =
    counts({DEVIATION_AT_PROTECTED_EDGE, DEVIATION_AT_SMALLEST_SIZE, DEVIATION_AT_FOLD, DEVIATION_AFTER_STOP},
           [&](const Deviation_obstacle obstacle)
           { return std::count(r.deviation_obstacles.begin(), r.deviation_obstacles.end(), obstacle); });
  const std::string quality_obstacles =
    counts({QUALITY_AT_FEATURE_ANGLE, QUALITY_AT_PROTECTED_EDGE, QUALITY_AT_CLOSE_CORNERS, QUALITY_BETWEEN_FEATURES,
            QUALITY_AT_FOLD, QUALITY_AT_INTERSECTION, QUALITY_AT_OTHER_FACES, QUALITY_AFTER_STOP},
           [&](const Quality_obstacle obstacle)
           {
             return std::count_if(r.low_quality_faces.begin(), r.low_quality_faces.end(),
                                  [=](const auto& low) { return low.obstacle == obstacle; });
           });

  os << "{\n"
     << "  \"input_faces\": " << r.number_of_input_faces << ",\n"
     << "  \"input_quality_min\": " << number(r.smallest_input_quality) << ",\n"
     << "  \"input_quality_mean\": " << number(r.mean_input_quality) << ",\n"
     << "  \"degenerate_input_faces\": " << r.number_of_degenerate_input_faces << ",\n"
     << "  \"folded_input_faces\": " << r.number_of_folded_input_faces << ",\n"
     << "  \"unrepaired_faces\": " << r.number_of_unrepaired_faces << ",\n"
     << "  \"faces\": " << r.number_of_faces << ",\n"
     << "  \"vertices\": " << r.number_of_vertices << ",\n"
     << "  \"quality_min\": " << number(r.smallest_quality) << ",\n"
     << "  \"quality_mean\": " << number(r.mean_quality) << ",\n"
     << "  \"deviation_max\": " << number(r.largest_deviation) << ",\n"
     << "  \"deviation_mean\": " << number(r.mean_deviation) << ",\n"
     << "  \"deviation_max_point\": [" << number(worst[0]) << ", " << number(worst[1]) << ", "
     << number(worst[2]) << "],\n"
     << "  \"model_distance_from_input\": " << number(r.distance_of_model_from_input) << ",\n"
     << "  \"maximum_deviation\": " << number(r.maximum_deviation) << ",\n"
     << "  \"maximum_deviation_met\": " << (r.is_maximum_deviation_met ? "true" : "false") << ",\n"
     << "  \"faces_above_maximum_deviation\": " << r.faces_above_maximum_deviation.size() << ",\n"
     << "  \"deviation_obstacles\": {" << deviation_obstacles << "},\n"
     << "  \"quality_obstacles\": {" << quality_obstacles << "},\n"
     << "  \"size_conformity\": " << number(r.size_conformity) << ",\n"
     << "  \"predicted_faces\": " << number(r.predicted_number_of_faces) << ",\n"
     << "  \"size_scale\": " << number(r.size_scale) << ",\n"
     << "  \"corners\": " << r.number_of_corners << ",\n"
     << "  \"curves\": " << r.number_of_curves << ",\n"
     << "  \"feature_edges\": " << r.number_of_feature_edges << ",\n"
     << "  \"iterations\": " << r.number_of_iterations << ",\n"
     << "  \"stop_reason\": \"" << name(r.stop_reason) << "\",\n"
     << "  \"counts\": {\"splits\": " << r.number_of_splits
     << ", \"collapses\": " << r.number_of_collapses << ", \"flips\": " << r.number_of_flips
     << ", \"vertex_removals\": " << r.number_of_vertex_removals << ", \"relocations\": " << r.number_of_relocations << "},\n"
     << "  \"seconds\": " << number(r.seconds) << ",\n"
     << "  \"stages\": {";
  const char* separator = "";
  for(const auto& stage : r.stages)
  {
    os << separator << "\"" << stage.first << "\": " << number(stage.second);
    separator = ", ";
  }
  os << "},\n  \"low_quality_faces\": [";
  separator = "";
  for(const auto& low : r.low_quality_faces)
  {
    os << separator << "\n    {\"quality\": " << number(low.quality) << ", \"point\": [" << number(low.point[0]) << ", "
       << number(low.point[1]) << ", " << number(low.point[2]) << "], \"obstacle\": \"" << name(low.obstacle)
       << "\", \"why\": \"" << explanation(low) << "\"}";
    separator = ",";
  }
  os << (r.low_quality_faces.empty() ? "" : "\n  ") << "]\n}\n";
}

template <typename Mesh>
void print_table(std::ostream& os,
                 const CGAL::Hermite_diffuse_remeshing::Remeshing_report<Mesh>& r)
{
  const auto row = [&os](const std::string& title, const double before, const double after)
  {
    os << std::left << std::setw(20) << title << std::right << std::setw(12) << before
       << std::setw(12) << after << "\n";
  };
  os << std::setw(32) << "before" << std::setw(12) << "after" << "\n" << std::setprecision(8);
  row("faces", static_cast<double>(r.number_of_input_faces),
      static_cast<double>(r.number_of_faces));
  os << "faces predicted     " << std::setw(24) << std::round(r.predicted_number_of_faces) << "\n";
  if(r.number_of_degenerate_input_faces + r.number_of_folded_input_faces > 0)
    row("degenerate, folded", static_cast<double>(r.number_of_degenerate_input_faces + r.number_of_folded_input_faces),
        static_cast<double>(r.number_of_unrepaired_faces));
  os << std::setprecision(4);
  row("smallest quality", r.smallest_input_quality, r.smallest_quality);
  row("mean quality", r.mean_input_quality, r.mean_quality);
  if(!r.low_quality_faces.empty())
    os << "low quality         " << r.low_quality_faces.size() << " faces; the worst: "
       << explanation(r.low_quality_faces.front()) << "\n";
  os << "deviation           largest " << r.largest_deviation << ", mean " << r.mean_deviation
     << "\n";
  if(!r.is_maximum_deviation_met)
    os << "                    above the bound " << r.maximum_deviation << " on "
       << r.faces_above_maximum_deviation.size() << " faces\n";
  os << "stopped             " << name(r.stop_reason) << " after " << r.number_of_iterations
     << " iterations\n"
     << "seconds             " << r.seconds << "\n";
  for(const auto& stage : r.stages)
    os << "  " << std::left << std::setw(18) << stage.first << stage.second << "\n";
}

#endif // HERMITE_DIFFUSE_REMESHING_EXAMPLES_REPORT_OUTPUT_H
