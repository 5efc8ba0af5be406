// Answers the questions of effects (FContentQuestions) from the channels of a scene.
#pragma once

#include "CoreMinimal.h"
#include "SceneFile/SceneResolution.h"
#include "SceneFile/ViewContent.h"

namespace Drydock
{

class FSceneFile;

/** The least rect that holds every pixel of Area for which IsMarked(X, Y) holds; without area where there is none. */
template<typename TPredicate>
FIntRect FindBounds(const FIntRect& Area, const TPredicate& IsMarked)
{
	FIntRect Bounds(Area.Max, Area.Min);
	for (int Y = Area.Min.Y; Y < Area.Max.Y; ++Y)
	{
		for (int X = Area.Min.X; X < Area.Max.X; ++X)
		{
			// Inside what is known already nothing is gained.
			const bool bKnown = Y < Bounds.Max.Y && X >= Bounds.Min.X && X < Bounds.Max.X;
			if (!bKnown && IsMarked(X, Y))
			{
				Bounds.Min = FIntPoint(FMath::Min(Bounds.Min.X, X), FMath::Min(Bounds.Min.Y, Y));
				Bounds.Max = FIntPoint(FMath::Max(Bounds.Max.X, X + 1), FMath::Max(Bounds.Max.Y, Y + 1));
			}
		}
	}
	return Bounds.Min.X < Bounds.Max.X ? Bounds : FIntRect(Area.Min, Area.Min);
}

/** Bounds in the file as bounds in the scene textures, both from the view's corner. If the resolution differs, the
 * whole view. */
DRYDOCK_API FIntRect MapBounds(const FIntRect& Bounds, const FSceneRegion& Region);

/** ViewRect: of a view in the scene textures. Reads the channels that it needs and the scene keeps them for Load;
 * throws FError (exit code 3) for a broken file. */
DRYDOCK_API FViewContent MeasureViewContent(
	FSceneFile& Scene, const FIntRect& ViewRect, const FContentQuestions& Questions);

} // namespace Drydock
