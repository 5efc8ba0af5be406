// Objects that settings refer to, by path: one object per path and class, so that equal paths are equal pointers and
// null is "None". Nothing is loaded.
#pragma once

#include "Curves/CurveFloat.h"
#include "Engine/Texture.h"

#include <string>

namespace Drydock
{

/** The one object of a path; made at the first call, kept to the end of the program. Null for "" and "None". Texture
 * and Texture2D give the same object, a UTexture2D. Any thread. */
DRYDOCK_API UTexture2D* FindOrAddTexture(const std::string& Path);
DRYDOCK_API UTextureCube* FindOrAddTextureCube(const std::string& Path);
DRYDOCK_API UCurveFloat* FindOrAddCurve(const std::string& Path);
/** Finds or adds an object for blendables, which may be of any class. */
DRYDOCK_API UObject* FindOrAddObject(const std::string& Path);

/** "None" for null; the name of an object that was not made here. Any thread. */
DRYDOCK_API std::string GetObjectPath(const UObject* Object);

/** `/Game/A.A` as it is; `Texture2D'/Game/A.A'` and `/Script/Engine.Texture2D'"/Game/A.A"'` without their class, as the
 * engine writes references. White space and quotes around a path are not part of it; the result strips to itself.
 * */
DRYDOCK_API std::string StripObjectClass(const std::string& Reference);

} // namespace Drydock
