#include "plugin/model_text.h"

namespace phs::plugin {

std::optional<std::string> CustomText(const mjModel* m, const std::string& name) {
  const int id = mj_name2id(m, mjOBJ_TEXT, name.c_str());
  if (id < 0) return std::nullopt;
  return std::string(m->text_data + m->text_adr[id]);
}

std::optional<double> CustomNumber(const mjModel* m, const std::string& name) {
  const int id = mj_name2id(m, mjOBJ_NUMERIC, name.c_str());
  if (id < 0 || m->numeric_size[id] < 1) return std::nullopt;
  return m->numeric_data[m->numeric_adr[id]];
}

std::vector<int> NamedTuple::Ids(int type) const {
  std::vector<int> ids;
  for (const TupleElement& element : elements) {
    if (element.type == type) ids.push_back(element.id);
  }
  return ids;
}

std::vector<NamedTuple> TuplesWithPrefix(const mjModel* m, const std::string& prefix) {
  std::vector<NamedTuple> tuples;
  for (int i = 0; i < m->ntuple; ++i) {
    const std::string name = ObjectName(m, mjOBJ_TUPLE, i);
    if (name.compare(0, prefix.size(), prefix) != 0) continue;
    NamedTuple tuple{name.substr(prefix.size()), {}};
    for (int k = 0; k < m->tuple_size[i]; ++k) {
      const int at = m->tuple_adr[i] + k;
      tuple.elements.push_back({m->tuple_objtype[at], m->tuple_objid[at]});
    }
    tuples.push_back(std::move(tuple));
  }
  return tuples;
}

std::string ObjectName(const mjModel* m, int type, int id) {
  const char* name = mj_id2name(m, type, id);
  return name == nullptr ? std::string() : std::string(name);
}

}  // namespace phs::plugin
