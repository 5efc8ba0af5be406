// Runs each pass of a plugin once more on its own inputs mirrored or shifted, and compares what it writes.
#pragma once

#include "DispatchObserver.h"
#include "Prove/PassRecord.h"

namespace Drydock
{

/** For the first draw or dispatch of a plugin whose result does not follow its inputs. Left out are those that do not
 * write a whole texture, or that read what they write or a buffer. Values are alike within a step of 8 bits; as many as
 * one pixel in 1000 may differ. A shift takes its texels around the border, and is judged in the middle quarter. */
class DRYDOCK_API FPassTransform final : public IDispatchObserver
{
public:
	explicit FPassTransform(EPassTransform InTransform)
		: Transform(InTransform)
	{
	}
	~FPassTransform() override;

	void AfterDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole) override;

	const std::optional<FFirstDifference>& GetDifference() const { return Difference; }

private:
	const EPassTransform Transform;
	std::optional<FFirstDifference> Difference;
};

} // namespace Drydock
