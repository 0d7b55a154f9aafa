#pragma once
/// A technique without its type, for those who run many of them.

#include <memory>
#include <utility>

#include "techniques/stage.h"
#include "techniques/technique.h"

namespace lode::experiments {

class AnyTechnique {
 public:
  template <techniques::Technique T>
  explicit AnyTechnique(T technique) : held_(std::make_unique<Held<T>>(std::move(technique))) {}

  [[nodiscard]] techniques::Promise promise() const { return held_->promise(); }
  void prepare(techniques::Stage& stage) { held_->prepare(stage); }
  void cut() { held_->cut(); }
  techniques::Counters draw(const techniques::View& view, techniques::Stage& stage) { return held_->draw(view, stage); }

 private:
  struct Base {
    virtual ~Base() = default;
    [[nodiscard]] virtual techniques::Promise promise() const = 0;
    virtual void prepare(techniques::Stage& stage) = 0;
    virtual void cut() = 0;
    virtual techniques::Counters draw(const techniques::View& view, techniques::Stage& stage) = 0;
  };
  template <class T>
  struct Held final : Base {
    explicit Held(T t) : technique(std::move(t)) {}
    [[nodiscard]] techniques::Promise promise() const override { return technique.promise(); }
    void prepare(techniques::Stage& stage) override { technique.prepare(stage); }
    void cut() override { technique.cut(); }
    techniques::Counters draw(const techniques::View& view, techniques::Stage& stage) override {
      return technique.draw(view, stage);
    }
    T technique;
  };
  std::unique_ptr<Base> held_;
};

}  // namespace lode::experiments
